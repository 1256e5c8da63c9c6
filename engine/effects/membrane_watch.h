#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Has a step taken again after which a cell's area or perimeter is out of its bounds or a membrane crosses
/// itself or another one, and notes the thinnest that each cell was.
extern const EffectKind membrane_watch;

}  // namespace rouleau::effects
