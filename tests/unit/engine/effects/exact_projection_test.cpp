#include "engine/effects/exact_projection.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

double greatest_divergence(const State& state) {
  std::vector<double> velocity, divergence;
  operators::interleave(state.particles.u, state.particles.v, velocity);
  state.operators.divergences(velocity.data(), divergence);
  double most = 0;
  for (std::size_t i = 0; i < divergence.size(); ++i) {
    most = std::max(most, std::abs(divergence[i] - state.source[i]));
  }
  return most * state.spacing;
}

double kinetic_energy(const State& state) {
  double energy = 0;
  for (int i = 0; i < state.particles.active_end(); ++i) {
    energy += std::pow(state.particles.u[i], 2) + std::pow(state.particles.v[i], 2);
  }
  return energy;
}

// A jet among walls at rest: what is nearest to it and free of divergence has less energy.
TEST(ExactProjection, TakesOutWhatDivergenceThereIs) {
  State state = prepared_state(coarse_vessel());
  auto& p = state.particles;
  for (int i = 0; i < p.active_end(); ++i) {
    p.u[i] = std::hypot(p.x[i] - 0.75, p.y[i] - 0.5) < 0.2 ? 0.1 : 0;
    p.v[i] = 0;
  }
  const double before = kinetic_energy(state);
  ASSERT_GT(greatest_divergence(state), 0.02);
  const auto effect = exact_projection.make(state);
  ASSERT_TRUE(effect->awake(state));
  effect->apply(state);
  EXPECT_LE(greatest_divergence(state), 6e-3 * (1 + 1e-9));
  EXPECT_LT(kinetic_energy(state), before);
  EXPECT_GT(kinetic_energy(state), 0.1 * before);
}

TEST(ExactProjection, SleepsInASmoothFlow) {
  State state = prepared_state(coarse_vessel());
  EXPECT_FALSE(exact_projection.make(state)->awake(state));
}

}  // namespace
}  // namespace rouleau::effects
