#include "engine/effects/transport.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

// 1 inside a cell, a half on its membrane, 0 in the plasma.
double colour(const State& state, int i) {
  if (state.particles.cell[i] < 0) return 0;
  return i < state.particles.membrane_end() ? 0.5 : 1;
}

TEST(Transport, ParticlesShiftedBesideAMembraneKeepThePressureOfTheirSide) {
  State state = prepared_state(coarse_vessel_with_cells());
  auto& particles = state.particles;
  const auto active = static_cast<std::size_t>(particles.active_end());
  for (int i = 0; i < particles.size(); ++i) {
    particles.u[i] = particles.v[i] = 0;
    particles.p[i] = 3 + (i < particles.active_end() ? 5 * colour(state, i) : 0);
  }
  for (auto* field : {&state.pressure_gx, &state.pressure_gy, &state.shift_x, &state.shift_y}) {
    field->assign(active, 0);
  }
  state.shift_x.assign(active, 0.1 * state.spacing);
  state.next_x = particles.x;
  state.next_y = particles.y;
  const std::vector<double> before = particles.p;

  transport.make(state)->apply(state);

  double most = 0;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    most = std::max(most, std::abs(particles.p[i] - before[i]));
  }
  EXPECT_LT(most, 1e-5);
}

}  // namespace
}  // namespace rouleau::effects
