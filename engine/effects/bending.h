#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Bending stiffness of the membranes, eq. 11 in conservative form.
extern const EffectKind bending;

}  // namespace rouleau::effects
