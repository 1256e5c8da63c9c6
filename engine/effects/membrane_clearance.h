#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Keeps fluid particles at least 0.4 spacings away from membrane links, each on its own side.
extern const EffectKind membrane_clearance;

}  // namespace rouleau::effects
