#pragma once

#include <vector>

#include "engine/effects/state.h"

namespace rouleau {

/// What the flow will make of a cell, judged from the scene alone. Made for cells in a channel and in shear,
/// from runs (docs/plan.md); elsewhere a guess.
struct ForeseenStretch {
  double rate = 0;       ///< at which the flow shears the cell, 1/s
  double capillary = 0;  ///< mu times rate times the cell's radius over E_s
  double most = 0;       ///< the perimeter's growth, over that at the start, that elasticity allows
  double at_end = 0;     ///< what of it the run's duration is enough for
};

ForeseenStretch foresee_stretch(const effects::State& start, const RedCell& cell);

/// A part of the run with one spacing.
struct SpacingSpan {
  double duration = 0;  ///< s
  double spacing = 0;   ///< m
};

/// As `thin_cells` will refine the spacing where a cell is foreseen to become too thin for it.
/// @param spacing  at the start, m
std::vector<SpacingSpan> foresee_spacings(const effects::State& start, double spacing);

}  // namespace rouleau
