#pragma once

#include <string>

#include "engine/effects/state.h"
#include "engine/error/simulation_error.h"
#include "engine/linear/bicgstab.h"

namespace rouleau::effects {

/// A watched quantity that is out of its bounds at the end of the step being made; SI.
struct Exceeded {
  std::string quantity;
  double value = 0;
  double bound = 0;
  std::string unit = "1";
  bool mendable = true;  ///< by a smaller step
  std::string advice{};  ///< what would help, if that is known
};

/// At a particle.
SimulationError breach_at(const State& state, int particle, Exceeded exceeded);
/// Of a cell as a whole, at (x, y).
SimulationError breach_of_cell(const State& state, int cell, double x, double y, Exceeded exceeded);
/// Of an equation of the step that its solver gave up: what is left of it is beyond the goal.
SimulationError unsolved(const State& state, const std::string& equation, const linear::Solve& solve);

}  // namespace rouleau::effects
