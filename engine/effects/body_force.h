#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// The case's uniform acceleration, on every particle (f of eq. 1).
extern const EffectKind body_force;

}  // namespace rouleau::effects
