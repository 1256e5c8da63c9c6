#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "tests/allocation/counting_new.h"

namespace rouleau {
namespace {

Case plasma(Profile profile) {
  Case scene;
  scene.vessel = {15e-6, 10e-6};
  scene.inflow.profile = profile;
  scene.numerics.spacing = 0.8e-6;
  scene.duration = 1;
  return scene;
}

class Plasma : public testing::TestWithParam<Profile> {};

TEST_P(Plasma, StepsAllocateNothingOnceEveryArrayHasItsSize) {
  Simulation simulation(plasma(GetParam()));
  // The fluid has passed through the vessel, so the numbers of particles and pairs have been what they can
  // be.
  for (int k = 0; k < 250; ++k) simulation.step();
  const long before = allocations();
  for (int k = 0; k < 50; ++k) simulation.step();
  EXPECT_EQ(allocations() - before, 0);
  EXPECT_GT(before, 0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Plasma, testing::Values(Profile::plug, Profile::parabolic));

}  // namespace
}  // namespace rouleau
