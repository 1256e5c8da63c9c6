#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Leaves walls and inlet particles whose neighbourhoods are cut off out of the pressure equation.
extern const EffectKind wall_end_exclusion;

}  // namespace rouleau::effects
