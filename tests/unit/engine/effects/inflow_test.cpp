#include "engine/effects/inflow.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

using particles::Group;

class InflowOfProfile : public testing::TestWithParam<Profile> {
 protected:
  InflowOfProfile() {
    Case scene = coarse_vessel();
    scene.inflow.profile = GetParam();
    scene.duration = 1.5e-3;
    simulation_.emplace(scene);
  }

  double lane_velocity(int k) const {
    const State& s = simulation_->state();
    return GetParam() == Profile::plug ? 1 / (1 - s.spacing)
                                       : State::parabola(s.row_y(k) / s.outline.height());
  }

  std::optional<Simulation> simulation_;
};

TEST_P(InflowOfProfile, EmitsExactlyWhatTheLanesCarry) {
  while (!simulation_->finished()) simulation_->step();
  const State& s = simulation_->state();
  // A lane is filled up when its foremost particle, at first half a spacing upstream and off by its stagger,
  // passes the plane.
  long expected = 0;
  for (int k = 1; k <= s.rows(); ++k) {
    const double fed = (s.row_offset(k) + lane_velocity(k) * s.time) / s.spacing - 0.5;
    expected += std::max(0L, static_cast<long>(std::ceil(fed - 1e-9)));
  }
  EXPECT_EQ(s.counters.emitted, expected);
  // That is the flux: height times mean velocity, a particle for each square of the spacing.
  EXPECT_NEAR(static_cast<double>(expected), s.time / (s.spacing * s.spacing), s.rows());
}

TEST_P(InflowOfProfile, BufferMovesInLanesAtTheirOwnVelocity) {
  for (int k = 0; k < 20; ++k) simulation_->step();
  const State& s = simulation_->state();
  const auto& particles = s.particles;
  ASSERT_GT(particles.inlet_end(), particles.first(Group::inlet));
  for (int i = particles.first(Group::inlet); i < particles.inlet_end(); ++i) {
    const int lane = static_cast<int>(std::lround(particles.y[i] / s.spacing));
    ASSERT_NEAR(particles.y[i], s.row_y(lane), 1e-12);
    ASSERT_DOUBLE_EQ(particles.u[i], lane_velocity(lane));
    ASSERT_EQ(particles.v[i], 0);
  }
}

TEST_P(InflowOfProfile, BufferParticlesFollowOneAnotherASpacingApart) {
  for (int k = 0; k < 20; ++k) simulation_->step();
  const State& s = simulation_->state();
  std::map<long, std::vector<double>> lanes;
  for (int i = s.particles.first(Group::inlet); i < s.particles.inlet_end(); ++i) {
    lanes[std::lround(s.particles.y[i] / s.spacing)].push_back(s.particles.x[i]);
  }
  for (auto& [lane, x] : lanes) {
    std::sort(x.begin(), x.end());
    for (std::size_t k = 1; k < x.size(); ++k)
      ASSERT_NEAR(x[k] - x[k - 1], s.spacing, 1e-9) << "lane " << lane;
  }
}

TEST_P(InflowOfProfile, TheNumberOfParticlesStaysWhatItWas) {
  const int start = simulation_->state().particles.active_end();
  while (!simulation_->finished()) simulation_->step();
  EXPECT_NEAR(simulation_->state().particles.active_end(), start, 0.06 * start);
  EXPECT_GT(simulation_->state().counters.absorbed, 20);
}

INSTANTIATE_TEST_SUITE_P(Profiles, InflowOfProfile, testing::Values(Profile::plug, Profile::parabolic));

}  // namespace
}  // namespace rouleau::effects
