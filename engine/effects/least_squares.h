#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Derivatives by least-squares fits at the present positions.
extern const EffectKind least_squares;

}  // namespace rouleau::effects
