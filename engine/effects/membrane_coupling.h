#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Hands the membranes' forces to the fluid. The normal part becomes a pressure jump through the very
/// gradient operator that acts on pressure, so that a resting jump is balanced exactly and nothing leaks;
/// forcing the nodes alone (eq. 13) makes them slip through the fluid. The tangential part is spread.
extern const EffectKind membrane_coupling;

}  // namespace rouleau::effects
