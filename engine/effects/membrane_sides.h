#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Puts a fluid particle that a membrane let through back on its own side, and counts it.
extern const EffectKind membrane_sides;

}  // namespace rouleau::effects
