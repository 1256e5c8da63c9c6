#include <algorithm>

#include "tests/validation/recorded_run.h"

namespace rouleau::validation {

namespace {

// Stokes flow over a semicircle of radius R on one wall of a channel of height H, by complex potentials
// (boundary residual 3e-8): peak axial velocity in the throat over the mean, and the pressure drop beyond
// the free channel's in mu U / H.
struct Bump {
  double radius_over_height, peak_velocity, extra_pressure_drop;
};

class FlowPastAThrombus : public testing::TestWithParam<Bump> {};

TEST_P(FlowPastAThrombus, MatchesStokesFlow) {
  const Bump bump = GetParam();
  Case scene = study_vessel(0.8e-3);
  scene.inflow.profile = Profile::parabolic;
  scene.thrombi.push_back({Wall::lower, 32e-6, bump.radius_over_height * 10e-6});
  const RecordedRun run(scene);
  const auto& u = run.frames.back().u;  // developed: pressure is slow to follow the start
  EXPECT_NEAR(*std::max_element(u.begin(), u.end()) / 0.005, bump.peak_velocity, 0.01 * bump.peak_velocity);
  const double unit = 1e-3 * 0.005 / 10e-6;
  const double free = 12 * unit * 80e-6 / 10e-6;
  const double extra = (run.column("pressure_drop").back() - free) / unit;
  EXPECT_NEAR(extra, bump.extra_pressure_drop, 0.03 * bump.extra_pressure_drop);
}

INSTANTIATE_TEST_SUITE_P(Radii, FlowPastAThrombus,
                         testing::Values(Bump{0.16, 1.71202, 4.1590}, Bump{0.32, 2.14130, 19.1904},
                                         Bump{0.48, 2.82932, 61.278}));

}  // namespace

}  // namespace rouleau::validation
