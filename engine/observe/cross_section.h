#pragma once

#include "engine/effects/state.h"

namespace rouleau::observe {

/// The flow through a plane across the vessel, in the simulation's units.
struct CrossSection {
  double flux = 0;      ///< integral of u over y
  double pressure = 0;  ///< mean of p over y
};

/// Measures at x by a quadratic least-squares fit at points across the vessel (walls are velocity data) and
/// Simpson's rule, which is exact for a parabola. Needs sorted particles.
CrossSection measure_cross_section(const effects::State& state, double x);

}  // namespace rouleau::observe
