#include "engine/effects/membrane_coupling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "engine/effects/stretch.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

class Coupling : public testing::Test {
 protected:
  Coupling() : state_(prepared_state(coarse_vessel_with_cells())), effect_(membrane_coupling.make(state_)) {}

  std::vector<double> rate_of(const std::vector<double>& velocity) const {
    std::vector<double> rate(velocity.size(), 0);
    for (const ImplicitForce* force : state_.implicit_forces) {
      force->add_response(velocity.data(), 1, rate.data());
    }
    return rate;
  }

  /// Any velocity, as long as it is neither uniform nor a rotation.
  std::vector<double> some_velocity() const {
    std::vector<double> velocity;
    for (int i = 0; i < state_.particles.active_end(); ++i) {
      velocity.push_back(std::sin(9 * state_.particles.y[i]));
      velocity.push_back(std::cos(7 * state_.particles.x[i]));
    }
    return velocity;
  }

  State state_;
  std::unique_ptr<Effect> effect_;
};

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

TEST_F(Coupling, WithoutALoadThereIsNoForce) {
  effect_->apply(state_);
  EXPECT_EQ(largest(state_.ax), 0);
  EXPECT_EQ(largest(state_.ay), 0);
  EXPECT_EQ(largest(rate_of(some_velocity())), 0);
}

TEST_F(Coupling, ALoadIsHandedToTheFluidNearTheMembraneWhole) {
  std::fill(state_.load.fx.begin(), state_.load.fx.end(), 1.0);
  effect_->apply(state_);
  double sum_x = 0, sum_y = 0;
  for (int i = 0; i < state_.particles.active_end(); ++i) {
    ASSERT_TRUE(std::isfinite(state_.ax[i]) && std::isfinite(state_.ay[i]));
    sum_x += state_.ax[i] * state_.spacing * state_.spacing;
    sum_y += state_.ay[i] * state_.spacing * state_.spacing;
    if (state_.ax[i] == 0) continue;
    double least = 1e9;
    for (int q = 0; q < state_.particles.membrane_end(); ++q) {
      least = std::min(least, std::hypot(state_.particles.x[i] - state_.particles.x[q],
                                         state_.particles.y[i] - state_.particles.y[q]));
    }
    ASSERT_LE(least, state_.radius);
  }
  const int nodes = state_.particles.membrane_end();
  EXPECT_NEAR(sum_x / nodes, 1, 0.01);
  EXPECT_NEAR(sum_y / nodes, 0, 0.01);
}

// Two forces along the normals at a time, as a mean normal force is a pressure jump and drives nothing.
TEST_F(Coupling, TheFluidReceivesWhatEachNodeGives) {
  const auto& p = state_.particles;
  const int nodes = p.membrane_end();
  const auto unit_normal = [&](int node) {
    const int before = (node + nodes - 1) % nodes, after = (node + 1) % nodes;
    const double tx = p.x[after] - p.x[before], ty = p.y[after] - p.y[before];
    return std::array{ty / std::hypot(tx, ty), -tx / std::hypot(tx, ty)};
  };
  for (int node = 0; node < nodes; ++node) {
    const int other = (node + nodes / 3) % nodes;
    const auto here = unit_normal(node), there = unit_normal(other);
    // Along the membrane, too, at the first of them.
    const double fx = here[0] + 0.5 * here[1], fy = here[1] - 0.5 * here[0];
    std::fill(state_.load.fx.begin(), state_.load.fx.end(), 0.0);
    std::fill(state_.load.fy.begin(), state_.load.fy.end(), 0.0);
    state_.load.fx[node] = fx;
    state_.load.fy[node] = fy;
    state_.load.fx[other] = -there[0];
    state_.load.fy[other] = -there[1];
    for (auto* field : {&state_.ax, &state_.ay}) std::fill(field->begin(), field->end(), 0.0);
    effect_->apply(state_);
    const double mass = state_.spacing * state_.spacing;
    EXPECT_NEAR(std::accumulate(state_.ax.begin(), state_.ax.end(), 0.0) * mass, fx - there[0], 0.01);
    EXPECT_NEAR(std::accumulate(state_.ay.begin(), state_.ay.end(), 0.0) * mass, fy - there[1], 0.01);
  }
}

// It goes into the pressure, and moves nothing: on a node it is the gradient of the enclosed area.
TEST_F(Coupling, AnEvenPressureOnTheMembraneIsTheGradientOfItsColour) {
  const auto& p = state_.particles;
  const int nodes = p.membrane_end();
  for (int node = 0; node < nodes; ++node) {
    const int before = (node + nodes - 1) % nodes, after = (node + 1) % nodes;
    state_.load.fx[node] = 3 * (p.y[after] - p.y[before]) / 2;
    state_.load.fy[node] = -3 * (p.x[after] - p.x[before]) / 2;
  }
  effect_->apply(state_);
  std::vector<double> jump(p.x.size(), 0), slope;
  for (int i = 0; i < p.active_end(); ++i) jump[i] = p.cell[i] < 0 ? 0 : i < nodes ? 1.5 : 3;
  state_.operators.pressure_gradients(jump.data(), slope);
  for (int i = 0; i < p.active_end(); ++i) {
    ASSERT_NEAR(state_.ax[i], -slope[2 * i], 1e-9 / state_.spacing);
    ASSERT_NEAR(state_.ay[i], -slope[2 * i + 1], 1e-9 / state_.spacing);
  }
}

TEST_F(Coupling, StiffnessAnswersLinearlyAndNotToATranslation) {
  stretch.make(state_)->apply(state_);
  effect_->apply(state_);
  const auto velocity = some_velocity();
  auto twice = velocity, translation = velocity;
  for (std::size_t k = 0; k < velocity.size(); ++k) {
    twice[k] *= 2;
    translation[k] = k % 2 ? -0.3 : 1;
  }
  const auto rate = rate_of(velocity), rate_twice = rate_of(twice);
  const double scale = largest(rate);
  ASSERT_GT(scale, 0);
  for (std::size_t k = 0; k < rate.size(); ++k) {
    ASSERT_TRUE(std::isfinite(rate[k]));
    ASSERT_NEAR(rate_twice[k], 2 * rate[k], 1e-12 * scale);
  }
  EXPECT_LT(largest(rate_of(translation)), 1e-10 * scale);
}

TEST_F(Coupling, StiffnessOpposesTheStretchingOfTheMembrane) {
  stretch.make(state_)->apply(state_);
  effect_->apply(state_);
  // The whole surroundings expand about the cell's centre: the membrane pulls its nodes back in.
  std::vector<double> expansion;
  const auto& p = state_.particles;
  const double cx = 0.8, cy = 0.5;
  for (int i = 0; i < p.active_end(); ++i) {
    expansion.push_back(p.x[i] - cx);
    expansion.push_back(p.y[i] - cy);
  }
  const auto rate = rate_of(expansion);
  EXPECT_LT(std::inner_product(rate.begin(), rate.end(), expansion.begin(), 0.0), 0);
}

}  // namespace
}  // namespace rouleau::effects
