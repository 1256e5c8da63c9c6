#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Attraction of the membranes of different cells across the plasma between them, which makes rouleaux: a
/// Morse potential for each length of membrane that faces another. In a periodic vessel images are other
/// cells.
extern const EffectKind aggregation;

}  // namespace rouleau::effects
