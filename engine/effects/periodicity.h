#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// What leaves at one end of a periodic vessel enters at the other.
extern const EffectKind periodicity;

}  // namespace rouleau::effects
