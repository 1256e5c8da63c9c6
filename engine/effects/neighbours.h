#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Sorts the particles, finds their neighbours and empties the fields that live for one step.
extern const EffectKind neighbours;

}  // namespace rouleau::effects
