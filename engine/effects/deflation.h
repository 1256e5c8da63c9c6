#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Lets cells that start as circles deflate to their area (section 2.4 of the study): the area that
/// `area_control` keeps falls evenly, and one by one, where they are most crowded, particles inside are taken
/// away.
extern const EffectKind deflation;

}  // namespace rouleau::effects
