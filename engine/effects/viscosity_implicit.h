#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Viscous step, implicit, with the membranes' stiffness in it:
/// (I - dt nu L - dt^2 S K) u* = u + dt (S F - grad p). Replaces the sub-steps of eqs. 14-18.
extern const EffectKind viscosity_implicit;

}  // namespace rouleau::effects
