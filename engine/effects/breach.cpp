#include "engine/effects/breach.h"

#include <cmath>

namespace rouleau::effects {

namespace {

/// A cell across the seam of a periodic vessel has nodes beyond its ends; the place is said within it.
double within(double position, double period) {
  return period > 0 ? position - period * std::floor(position / period) : position;
}

Breach breach_in(const State& state, double x, double y, Exceeded exceeded) {
  return {.quantity = std::move(exceeded.quantity),
          .value = exceeded.value,
          .bound = exceeded.bound,
          .unit = std::move(exceeded.unit),
          .time = (state.time + state.dt) * state.scales.time(),
          .step = state.step + 1,
          .x = within(x, state.outline.period_x()) * state.scales.length,
          .y = within(y, state.outline.period_y()) * state.scales.length,
          .mendable = exceeded.mendable,
          .advice = std::move(exceeded.advice)};
}

}  // namespace

SimulationError breach_at(const State& state, int particle, Exceeded exceeded) {
  Breach breach =
      breach_in(state, state.particles.x[particle], state.particles.y[particle], std::move(exceeded));
  breach.particle = state.particles.id[particle];
  breach.cell = state.particles.cell[particle];
  return SimulationError(std::move(breach));
}

SimulationError breach_of_cell(const State& state, int cell, double x, double y, Exceeded exceeded) {
  Breach breach = breach_in(state, x, y, std::move(exceeded));
  breach.cell = cell;
  return SimulationError(std::move(breach));
}

SimulationError unsolved(const State& state, const std::string& equation, const linear::Solve& solve) {
  return SimulationError(breach_in(state, 0, 0, {"residual of the " + equation, solve.residual, solve.goal}));
}

}  // namespace rouleau::effects
