#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Keeps the area of each cell: the fluid inside keeps its own, so what drifts is where the membrane is, and
/// that is moved back along its normal, by thousandths of a spacing.
extern const EffectKind area_control;

}  // namespace rouleau::effects
