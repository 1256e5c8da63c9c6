#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Lets particles out through each outlet plane, and back: a buffer four spacings deep that moves as the
/// fluid arrives at the plane, and whose pressure has the outlet's value there and goes on with the slope
/// found just before it.
extern const EffectKind outflow;

}  // namespace rouleau::effects
