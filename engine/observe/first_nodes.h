#pragma once

#include <vector>

#include "engine/cells/ring.h"
#include "engine/effects/state.h"

namespace rouleau::observe {

/// The nodes that a cell's membrane had at first, each where it is now: evenly spaced along the unstretched
/// membrane, l0 apart. The present ones may have been placed anew.
struct FirstNodes {
  std::vector<double> x, y, u, v, p;  ///< [start_nodes]; none once the cell has left

  cells::Ring ring() const { return {x, y}; }
};

FirstNodes first_nodes(const effects::State& state, const effects::CellState& cell);

}  // namespace rouleau::observe
