#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Takes out divergence that the pressure leaves where the flow is rough.
extern const EffectKind exact_projection;

}  // namespace rouleau::effects
