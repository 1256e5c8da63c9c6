#pragma once

#include <string>

#include "engine/effects/state.h"
#include "engine/error/simulation_error.h"

namespace rouleau::effects {

/// A watched quantity that is out of its bounds at the end of the step being made; SI.
struct Exceeded {
  std::string quantity;
  double value = 0;
  double bound = 0;
  std::string unit = "1";
  bool mendable = true;  ///< by a smaller step
};

/// At a particle.
SimulationError breach_at(const State& state, int particle, Exceeded exceeded);
/// Of a cell as a whole, at (x, y).
SimulationError breach_of_cell(const State& state, int cell, double x, double y, Exceeded exceeded);

}  // namespace rouleau::effects
