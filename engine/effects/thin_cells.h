#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// What is squeezed to a film of fewer than two particles cannot be carried by them, and no smaller step
/// cures it: sees it coming and asks for a finer spacing, or ends the run.
extern const EffectKind thin_cells;

// Mean thickness 2 A / P of a cell, in spacings, that calls for finer ones, and that they restore.
inline constexpr double seen_coming = 2, restored = 3;
// No spacing is finer than that of the start over this.
inline constexpr double most_refinement = 3;

}  // namespace rouleau::effects
