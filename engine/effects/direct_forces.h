#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// The published scheme's coupling, eq. 13: a membrane node is a fluid particle that its own springs
/// accelerate, and nothing around it is. It slips through the fluid, which leaks past it.
extern const EffectKind direct_forces;

}  // namespace rouleau::effects
