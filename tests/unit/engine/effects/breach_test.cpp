#include "engine/effects/breach.h"

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

TEST(Breach, OfAnEquationIsAtTheStepBeingMadeAndNowhere) {
  State state = prepared_state(coarse_vessel());
  state.time = 3;
  state.dt = 0.5;
  state.step = 6;
  linear::Solve solve;
  solve.residual = 0.2;
  solve.goal = 0.1;
  const Breach breach = unsolved(state, "pressure equation", solve).breach();
  EXPECT_EQ(breach.quantity, "residual of the pressure equation");
  EXPECT_EQ(breach.value, 0.2);
  EXPECT_EQ(breach.bound, 0.1);
  EXPECT_EQ(breach.step, 7);
  EXPECT_DOUBLE_EQ(breach.time, 3.5 * state.scales.time());
  EXPECT_FALSE(breach.has_place());
  EXPECT_TRUE(breach.mendable);
}

TEST(Breach, OfACellAcrossASeamIsInTheVessel) {
  const State state = prepared_state(pair_around(0));
  const double length = state.outline.period_x();
  for (const double beyond : {-0.1, 0.0, 1.0}) {
    const Breach breach = breach_of_cell(state, 1, beyond * length, 0.5, {"area", 1, 0}).breach();
    EXPECT_NEAR(breach.x, (beyond < 0 ? 0.9 : 0) * 20e-6, 1e-18);
    EXPECT_NEAR(breach.y, 5e-6, 1e-18);
    EXPECT_TRUE(breach.has_place());
  }
  const State open = prepared_state(coarse_vessel());
  EXPECT_NEAR(breach_of_cell(open, 0, -0.1, 0.5, {"area", 1, 0}).breach().x, -1e-6, 1e-18);
}

}  // namespace
}  // namespace rouleau::effects
