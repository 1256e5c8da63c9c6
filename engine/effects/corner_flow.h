#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// In the corners between walls that move apart the operators are those of the flow less the Stokes flow
/// there, whose own derivatives are known.
extern const EffectKind corner_flow;

}  // namespace rouleau::effects
