#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Has a step taken again after which a value is not finite or a speed or divergence is out of bounds, and
/// says what, when, where.
extern const EffectKind watch;

/// The speed that nothing in the scene's flow reaches.
double speed_bound(const State& state);

}  // namespace rouleau::effects
