#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Pressure of the published scheme: eq. 9 against the density source by conjugate gradients.
extern const EffectKind pressure_density;

}  // namespace rouleau::effects
