#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Tension of the membranes, eq. 10.
extern const EffectKind stretch;

}  // namespace rouleau::effects
