#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Cells heavier than plasma sink: the weight of a cell less its buoyancy, (rho_cell - rho) g on what it
/// encloses, along -y.
extern const EffectKind sedimentation;

}  // namespace rouleau::effects
