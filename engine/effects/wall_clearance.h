#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Keeps fluid particles at least 0.4 spacings away from the true wall.
extern const EffectKind wall_clearance;

}  // namespace rouleau::effects
