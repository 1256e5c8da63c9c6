#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Bending springs as the study prints them, eq. 11.
extern const EffectKind printed_bending;

}  // namespace rouleau::effects
