#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Evens out the particles: moves each down the gradient of crowding, at most a tenth of a spacing.
extern const EffectKind shifting;

}  // namespace rouleau::effects
