#include <gtest/gtest.h>

#include "tests/validation/recorded_run.h"

namespace rouleau::validation {
namespace {

// What flows in passes every line from wall to wall, however it is drawn.
TEST(Probes, TheFluxThroughAnyLineAcrossIsThatOfTheVessel) {
  Case scene;
  scene.vessel = {40e-6, 10e-6};
  scene.inflow.profile = Profile::parabolic;
  scene.duration = 2e-4;
  scene.probes = {{"upright", {20e-6, 0}, {20e-6, 10e-6}, 2},
                  {"oblique", {12e-6, 0}, {27e-6, 10e-6}, 2},
                  {"downwards", {33e-6, 10e-6}, {18e-6, 0}, 2},
                  {"too long", {22e-6, -5e-6}, {24e-6, 15e-6}, 2}};
  const RecordedRun run(scene);
  const double exact = 0.005 * 10e-6;
  for (std::size_t k = 0; k < scene.probes.size(); ++k) {
    const double sign = scene.probes[k].name == "downwards" ? -1 : 1;
    EXPECT_NEAR(run.probes.at(k).flux, sign * exact, 0.001 * exact) << scene.probes[k].name;
  }
}

// Past a bump, too: what the plasma is squeezed by shows in the velocities, not in the flux.
TEST(Probes, TheFluxPastABumpIsThatOfTheVessel) {
  Case scene;
  scene.vessel = {40e-6, 10e-6};
  scene.inflow.profile = Profile::parabolic;
  scene.thrombi.push_back({Wall::lower, 20e-6, 3.2e-6});
  scene.duration = 2e-4;
  scene.probes = {{"throat", {20e-6, 0}, {20e-6, 10e-6}, 2}, {"oblique", {16e-6, 0}, {23e-6, 10e-6}, 2}};
  const RecordedRun run(scene);
  const double exact = 0.005 * 10e-6;
  for (const ProbeValues& probe : run.probes) EXPECT_NEAR(probe.flux, exact, 0.005 * exact);
  EXPECT_NEAR(run.probes.at(0).u.back(), 0, 1e-4);
}

}  // namespace
}  // namespace rouleau::validation
