#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Asks for the divergence inside a cell by which its area falls as `deflation` wants it to.
extern const EffectKind deflation_sink;

}  // namespace rouleau::effects
