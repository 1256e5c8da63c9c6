#include "engine/observe/fahraeus.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/observe/cells_of_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

Hematocrit hematocrit_of(const effects::State& state) {
  return hematocrit(cell_flux(state, flow_planes(state)));
}

TEST(Fahraeus, OfACellThatMovesWithTheMeanFlowIsOne) {
  effects::State state = effects::prepared_state(coarse_vessel_with_cells());
  set_velocity(state, [](double, double) { return std::array{0.7, 0.0}; });
  const Hematocrit found = hematocrit_of(state);
  EXPECT_NEAR(found.tube, 0.6 * std::numbers::pi / 4 * 0.636 * 0.636 / 2, 2e-3);
  EXPECT_NEAR(found.ratio(), 1, 1e-6);
}

TEST(Fahraeus, OfAPointOnTheAxisOfPoiseuilleFlowIsTwoThirds) {
  effects::State state = effects::prepared_state(coarse_vessel_with_cells());
  set_velocity(state, [](double, double y) { return std::array{effects::State::parabola(y), 0.0}; });
  for (int i = 0; i < state.particles.membrane_end(); ++i) state.particles.u[i] = 1.5;
  put_nodes(state, 0, [](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return std::array{1 + 1e-3 * std::cos(angle), 0.5 + 1e-3 * std::sin(angle)};
  });
  EXPECT_NEAR(hematocrit_of(state).ratio(), 2.0 / 3, 1e-6);
}

TEST(Fahraeus, IsNoneWhereNothingFlows) {
  effects::State state = effects::prepared_state(coarse_vessel_with_cells());
  set_velocity(state, [](double, double) { return std::array{0.0, 0.0}; });
  EXPECT_TRUE(std::isnan(hematocrit_of(state).ratio()));
}

TEST(Fahraeus, ComparesWithTheFitForTubes) {
  // Pries et al.: at H_D = 0.45 the ratio is least, some 0.7, in tubes of about 12 um, and near 1 in wide
  // ones.
  EXPECT_NEAR(fahraeus_ratio_of_tubes(12e-6, 0.45), 0.717, 0.001);
  EXPECT_LT(fahraeus_ratio_of_tubes(12e-6, 0.45), fahraeus_ratio_of_tubes(6e-6, 0.45));
  EXPECT_LT(fahraeus_ratio_of_tubes(12e-6, 0.45), fahraeus_ratio_of_tubes(30e-6, 0.45));
  EXPECT_NEAR(fahraeus_ratio_of_tubes(1e-3, 0.45), 1, 1e-4);
  EXPECT_EQ(fahraeus_ratio_of_tubes(12e-6, 1), 1);
}

}  // namespace
}  // namespace rouleau::observe
