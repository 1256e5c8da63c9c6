#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Takes a fifth of the density source.
extern const EffectKind density_source_relaxation;

}  // namespace rouleau::effects
