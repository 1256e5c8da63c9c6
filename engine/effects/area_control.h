#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Keeps the area of each cell: asks for a small divergence inside it that undoes its drift.
extern const EffectKind area_control;

}  // namespace rouleau::effects
