#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Carries every moving particle along with the flow.
extern const EffectKind advection;

}  // namespace rouleau::effects
