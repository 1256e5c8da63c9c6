#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Lets cells out of the vessel. From ten spacings before an outlet on a cell loses its `presence` as its
/// foremost node goes on, smoothly in distance, so that the pressure inside it sinks to the plasma's; four
/// spacings before the plane, where the outlet's own measures of the flow begin, nothing of the membrane is
/// left and its nodes and what they enclose go on as plasma.
extern const EffectKind departure;

}  // namespace rouleau::effects
