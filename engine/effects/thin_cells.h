#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// What is squeezed to a film of fewer than two particles cannot be carried by them, and no smaller step
/// cures it: sees it coming and asks for a finer spacing, or ends the run.
extern const EffectKind thin_cells;

}  // namespace rouleau::effects
