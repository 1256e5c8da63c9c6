#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Takes particles out beyond the outlet plane: a buffer of frozen velocity, four spacings deep, whose
/// pressure has the outlet's value in the plane and goes on with the slope found just before it.
extern const EffectKind outflow;

}  // namespace rouleau::effects
