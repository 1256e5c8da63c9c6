#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Lets the forces of a membrane fade with its cell's `presence`, all alike.
extern const EffectKind fading;

}  // namespace rouleau::effects
