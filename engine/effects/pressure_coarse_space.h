#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Groups the unknowns of the published scheme's pressure equation into cells for a coarse space beside the
/// solver's diagonal: a tenth of the iterations for the same pressure.
extern const EffectKind pressure_coarse_space;

}  // namespace rouleau::effects
