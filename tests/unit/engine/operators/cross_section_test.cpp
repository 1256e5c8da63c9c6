#include "engine/operators/cross_section.h"

#include <gtest/gtest.h>

#include "tests/unit/engine/operators/disordered_vessel.h"

namespace rouleau::operators {
namespace {

constexpr double spacing = 0.1;

SamplingPlane plane_at(double x) {
  return {{x, 0}, {x, 1}, {3.1 * spacing}, 20};
}

/// A parabola of mean velocity 1, and pressure falling along x.
particles::ParticleSet poiseuille(unsigned seed) {
  auto set = disordered_vessel(2, spacing, 0.3, seed);
  for (int i = 0; i < set.size(); ++i) {
    set.u[i] = 6 * set.y[i] * (1 - set.y[i]);
    set.p[i] = i < set.pressure_end() ? 5 - 2 * set.x[i] : 1e6;
  }
  return set;
}

TEST(CrossSection, FluxOfAParabolaIsExact) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto set = poiseuille(seed);
    for (const double x : {0.2, 0.73, 1.0, 1.8}) {
      ASSERT_NEAR(measure_flux(set, plane_at(x)), 1, 1e-9) << "seed " << seed << ", x = " << x;
    }
  }
}

TEST(CrossSection, PressureIsThatOfTheFluidAtThePlane) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto set = poiseuille(seed);
    for (const double x : {0.4, 1.0, 1.6}) {
      const CrossSection section = measure(set, plane_at(x));
      ASSERT_NEAR(section.pressure, 5 - 2 * x, 1e-9) << "seed " << seed << ", x = " << x;
      ASSERT_EQ(section.flux, measure_flux(set, plane_at(x)));
    }
  }
}

TEST(CrossSection, FluxFollowsTheDirectionOfTheFlow) {
  auto set = poiseuille(1);
  for (double& u : set.u) u = -0.5 * u;
  EXPECT_NEAR(measure_flux(set, plane_at(1)), -0.5, 1e-9);
}

TEST(CrossSection, FluxThroughAnObliquePlaneIsThatThroughTheVessel) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto set = poiseuille(seed);
    for (const double slant : {-0.8, 0.1, 0.9}) {
      const SamplingPlane plane{{1, 0}, {1 + slant, 1}, {3.1 * spacing}, 20};
      ASSERT_NEAR(measure_flux(set, plane), 1, 1e-9) << "seed " << seed << ", slant " << slant;
      const SamplingPlane reversed{{1 + slant, 1}, {1, 0}, {3.1 * spacing}, 20};
      ASSERT_NEAR(measure_flux(set, reversed), -1, 1e-9) << "seed " << seed << ", slant " << slant;
    }
  }
}

TEST(CrossSection, NothingFlowsThroughALineAlongTheFlow) {
  const auto set = poiseuille(2);
  const SamplingPlane along{{0.2, 0.5}, {1.8, 0.5}, {3.1 * spacing}, 10};
  EXPECT_NEAR(measure_flux(set, along), 0, 1e-9);
  EXPECT_NEAR(measure(set, along).pressure, 5 - 2 * 1, 1e-9);
}

TEST(CrossSection, WhereThereIsNothingThereIsNoFlow) {
  const auto set = poiseuille(1);
  EXPECT_EQ(measure_flux(set, plane_at(50)), 0);
  EXPECT_EQ(measure({}, plane_at(1)).pressure, 0);
}

}  // namespace
}  // namespace rouleau::operators
