#include "engine/effects/watch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "engine/error/simulation_error.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Behind a parabola the flow that a scene begins with is free of divergence: behind a plug it is not yet.
State sound_state() {
  Case scene = coarse_vessel_with_cells();
  scene.inflow.profile = Profile::parabolic;
  return prepared_state(scene);
}

/// Two halves that run into one another.
State colliding_state() {
  State state = sound_state();
  for (int i = 0; i < state.particles.velocity_end(); ++i) {
    state.particles.u[i] += state.particles.x[i] < 0.7 ? 6 : -6;
  }
  return state;
}

TEST(Watch, LetsASoundStatePassAndNotesItsSpeed) {
  State state = sound_state();
  for (double& u : state.particles.u) u *= -1.25;
  double fastest = 0;
  for (int i = 0; i < state.particles.active_end(); ++i) {
    fastest = std::max(fastest, std::abs(state.particles.u[i]));
  }
  watch.make(state)->apply(state);
  EXPECT_DOUBLE_EQ(state.speed, fastest);
  EXPECT_DOUBLE_EQ(state.counters.peak_speed, fastest);
  EXPECT_LT(state.counters.worst_divergence, 0.01);
}

TEST(Watch, AFlowFromNowhereIsABreach) {
  State state = colliding_state();
  try {
    watch.make(state)->apply(state);
    FAIL() << "went on";
  } catch (const SimulationError& error) {
    EXPECT_EQ(error.breach().quantity, "divergence");
    EXPECT_GE(error.breach().particle, 0);
    EXPECT_GT(error.breach().value, error.breach().bound);
  }
}

TEST(Watch, WhatIsWantedIsNoBreach) {
  State state = colliding_state();
  std::vector<double> velocity;
  operators::interleave(state.particles.u, state.particles.v, velocity);
  state.operators.divergences(velocity.data(), state.source);
  EXPECT_NO_THROW(watch.make(state)->apply(state));
}

struct Wrong {
  const char* name;
  const char* quantity;
  std::function<void(particles::ParticleSet&, int)> spoil;
};

class WatchStops : public testing::TestWithParam<Wrong> {};

/// Of a plasma particle and of a membrane node.
TEST_P(WatchStops, AndSaysWhatWhenAndWhere) {
  for (const int i : {7, 90}) {
    State state = prepared_state(coarse_vessel_with_cells());
    state.step = 41;
    state.time = 0.3;
    const double x = state.particles.x[i] * 10e-6, y = state.particles.y[i] * 10e-6;
    GetParam().spoil(state.particles, i);
    const auto effect = watch.make(state);
    try {
      effect->apply(state);
      FAIL() << "went on";
    } catch (const SimulationError& error) {
      const Breach& breach = error.breach();
      EXPECT_EQ(breach.quantity, GetParam().quantity);
      EXPECT_FALSE(breach.value <= breach.bound && std::isfinite(breach.value));
      EXPECT_FALSE(breach.unit.empty());
      EXPECT_EQ(breach.particle, state.particles.id[i]);
      EXPECT_EQ(breach.cell, state.particles.cell[i]);
      EXPECT_EQ(breach.step, 42);
      EXPECT_NEAR(breach.time, (0.3 + state.dt) * 10e-6 / 0.005, 1e-12);
      if (breach.quantity != "position") {
        EXPECT_NEAR(breach.x, x, 1e-15);
        EXPECT_NEAR(breach.y, y, 1e-15);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Values, WatchStops,
    testing::Values(Wrong{"velocity_nan", "speed", [](auto& p, int i) { p.v[i] = nan; }},
                    Wrong{"velocity_infinite", "speed", [](auto& p, int i) { p.u[i] = -infinity; }},
                    Wrong{"speed_exploding", "speed", [](auto& p, int i) { p.u[i] = 1e3; }},
                    Wrong{"pressure_nan", "pressure", [](auto& p, int i) { p.p[i] = nan; }},
                    Wrong{"pressure_infinite", "pressure", [](auto& p, int i) { p.p[i] = infinity; }},
                    Wrong{"position_nan", "position", [](auto& p, int i) { p.x[i] = nan; }},
                    Wrong{"position_infinite", "position", [](auto& p, int i) { p.y[i] = infinity; }}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(Watch, NothingMayCrossASpacingInAStep) {
  State state = prepared_state(coarse_vessel());
  state.dt = state.spacing;  // the bound is then a speed of 1, and the flow's own is 1.5
  EXPECT_THROW(watch.make(state)->apply(state), SimulationError);
}

}  // namespace
}  // namespace rouleau::effects
