#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Cells whose inside is more viscous than the plasma: the stress becomes nu (grad u + grad u^T) with nu a
/// field.
extern const EffectKind viscosity_contrast;

}  // namespace rouleau::effects
