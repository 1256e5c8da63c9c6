#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Moves the particles, and with them what they carry: r + dt u, which is the published scheme's predicted
/// position with its correction.
extern const EffectKind particle_motion;

}  // namespace rouleau::effects
