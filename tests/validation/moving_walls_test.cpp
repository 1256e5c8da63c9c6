#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/validation/flow.h"

namespace rouleau::validation {
namespace {

constexpr double height = 10e-6;
constexpr double speed = 0.005;

/// Both walls move, in opposite directions; the case asks for steps in which they go `courant` spacings.
Case between_moving_walls(double courant, long steps) {
  Case scene;
  scene.vessel = {2 * height, height};
  scene.vessel.ends = Ends::periodic;
  scene.vessel.wall_velocity.lower = -speed;
  scene.vessel.wall_velocity.upper = speed;
  scene.numerics = numerics_at({16, Preset::standard}, height);
  scene.numerics.time_step = courant * scene.numerics.spacing / speed;
  scene.duration = static_cast<double>(steps) * *scene.numerics.time_step;
  return scene;
}

class CouetteFlowByLargeSteps : public testing::TestWithParam<double> {};

// Explicit transport of pressure amplifies the divergence where |u| dt/d0 exceeds 0.7. Either the steps are
// stable over a long run or they are held back, and the counts say so. The rows slide by one another all the
// time, so the divergence is never nothing.
TEST_P(CouetteFlowByLargeSteps, DivergenceDoesNotGrow) {
  const double courant = GetParam();
  constexpr long steps = 1000;
  Flow flow(between_moving_walls(courant, steps));
  const double asked = courant * flow.state().spacing / (speed / flow.state().scales.velocity);
  double early = 0, late = 0, fastest = 0;
  while (flow.time() < flow.state().scene.duration * (1 - 1e-9)) {
    flow.step();
    const double part = flow.time() / flow.state().scene.duration;
    double& most = part < 0.5 ? early : late;
    if (part > 0.1) most = std::max(most, flow.divergence());
    fastest = std::max(fastest, flow.state().speed);
  }
  EXPECT_LE(late, 2 * early + 1e-6);
  EXPECT_LE(fastest, 1.01 * speed / flow.state().scales.velocity);
  const StepCounts& counts = flow.step_counts();
  const auto held_by = [&](Limit limit) { return counts.bound[static_cast<std::size_t>(limit)]; };
  if (courant > 0.5) {
    EXPECT_LE(counts.most, 0.6 * asked / courant);
    EXPECT_GT(held_by(Limit::flow), steps / 2);
  } else {
    EXPECT_GT(held_by(Limit::planned), steps / 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, CouetteFlowByLargeSteps, testing::Values(0.1, 0.5, 1.0, 2.0));

}  // namespace
}  // namespace rouleau::validation
