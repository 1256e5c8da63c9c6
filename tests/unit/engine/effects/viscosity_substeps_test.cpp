#include "engine/effects/viscosity_substeps.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/published_state.h"

namespace rouleau::effects {
namespace {

/// u = y^2 and v = -2 x^2.
State with_quadratic_velocity() {
  State state = published_state();
  auto& particles = state.particles;
  for (int i = 0; i < particles.size(); ++i) {
    particles.u[i] = particles.y[i] * particles.y[i];
    particles.v[i] = -2 * particles.x[i] * particles.x[i];
  }
  return state;
}

TEST(ViscositySubsteps, AddsTheLaplacianTimesViscosityAndTime) {
  State state = with_quadratic_velocity();
  state.scene.numerics.substeps = 1;
  state.dt = 1e-3;
  const auto before = state.particles;
  run(state, {&viscosity_substeps});
  const double gain = 2 * state.viscosity * state.dt;
  int checked = 0;
  for (int i = 0; i < before.active_end(); ++i) {
    if (!deep_inside(state, i)) continue;
    EXPECT_NEAR(state.particles.u[i], before.u[i] + gain, 1e-4 * gain);
    EXPECT_NEAR(state.particles.v[i], before.v[i] - 2 * gain, 1e-4 * gain);
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

TEST(ViscositySubsteps, AreAsManyStepsOfAFractionOfTheTime) {
  State once = with_quadratic_velocity(), often = with_quadratic_velocity();
  once.scene.numerics.substeps = 4;
  once.dt = 4e-4;
  run(once, {&viscosity_substeps});
  often.scene.numerics.substeps = 1;
  often.dt = 1e-4;
  for (int k = 0; k < 4; ++k) run(often, {&viscosity_substeps});
  for (int i = 0; i < once.particles.size(); ++i) {
    EXPECT_NEAR(once.particles.u[i], often.particles.u[i], 1e-12);
    EXPECT_NEAR(once.particles.v[i], often.particles.v[i], 1e-12);
  }
}

TEST(ViscositySubsteps, ForcesActBeforeThem) {
  State state = published_state();
  state.viscosity = 0;
  state.ax.assign(state.ax.size(), 3);
  state.ay.assign(state.ay.size(), -2);
  run(state, {&viscosity_substeps});
  for (int i = 0; i < state.particles.size(); ++i) {
    const bool moves = i < state.particles.active_end();
    EXPECT_DOUBLE_EQ(state.particles.u[i], moves ? 3 * state.dt : 0);
    EXPECT_DOUBLE_EQ(state.particles.v[i], moves ? -2 * state.dt : 0);
  }
}

TEST(ViscositySubsteps, SlowDownAShearAtAWallAtRest) {
  State state = published_state();
  for (int i = 0; i < state.particles.inlet_end(); ++i) state.particles.u[i] = 1;
  run(state, {&viscosity_substeps});
  for (int i = 0; i < state.particles.active_end(); ++i) {
    EXPECT_GT(state.particles.u[i], 0);
    EXPECT_LT(state.particles.u[i], 1 + 1e-12);
    if (std::abs(state.particles.y[i] - 0.5) < 0.35) continue;
    EXPECT_LT(state.particles.u[i], 0.9);
  }
}

}  // namespace
}  // namespace rouleau::effects
