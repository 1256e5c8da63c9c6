#pragma once

#include "engine/effects/state.h"

namespace rouleau::observe {

/// A cell at one instant, in SI units; angle in degrees.
struct CellMeasures {
  double x = 0, y = 0;  ///< centroid of the enclosed area
  double u = 0, v = 0;  ///< its velocity
  double tau = 1;       ///< eq. 23 over the membrane's nodes, against the start
  double tau_area = 1;  ///< the same over the enclosed area
  double area = 0, perimeter = 0;
  double angle = 0;  ///< of the long axis to x
};

CellMeasures measure_cell(const effects::State& state, const effects::CellState& cell);

}  // namespace rouleau::observe
