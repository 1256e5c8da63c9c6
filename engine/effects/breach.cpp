#include "engine/effects/breach.h"

namespace rouleau::effects {

namespace {

Breach breach_in(const State& state, double x, double y, Exceeded exceeded) {
  return {.quantity = std::move(exceeded.quantity),
          .value = exceeded.value,
          .bound = exceeded.bound,
          .unit = std::move(exceeded.unit),
          .time = (state.time + state.dt) * state.scales.time(),
          .step = state.step + 1,
          .x = x * state.scales.length,
          .y = y * state.scales.length,
          .mendable = exceeded.mendable};
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

}  // namespace rouleau::effects
