#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Viscous step of the published scheme: M explicit sub-steps, eqs. 14 and 16 to 18, with the Laplacian of
/// eq. 6.
extern const EffectKind viscosity_substeps;

}  // namespace rouleau::effects
