#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Lets the pressure gradient take neighbours' pressures against the least of the neighbourhood.
extern const EffectKind gradient_from_least_pressure;

}  // namespace rouleau::effects
