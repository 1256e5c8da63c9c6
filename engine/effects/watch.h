#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Ends the run at the first value that is not finite or speed out of bounds, and says what, when, where.
extern const EffectKind watch;

}  // namespace rouleau::effects
