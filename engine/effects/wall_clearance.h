#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Keeps fluid particles at least 0.4 spacings away from the true wall, and 1.4 from a corner whose walls
/// move apart.
extern const EffectKind wall_clearance;

}  // namespace rouleau::effects
