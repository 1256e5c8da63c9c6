#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Corrects the velocity by the pressure gradient: eqs. 3 and 5.
extern const EffectKind velocity_correction;

}  // namespace rouleau::effects
