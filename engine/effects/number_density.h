#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Moves the particles on with u* alone, counts their number density there (eq. 8) and makes it the source of
/// the pressure equation (eq. 7).
extern const EffectKind number_density;

}  // namespace rouleau::effects
