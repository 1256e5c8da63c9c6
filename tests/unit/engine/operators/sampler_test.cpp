#include "engine/operators/sampler.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/operators/disordered_vessel.h"

namespace rouleau::operators {
namespace {

constexpr double spacing = 0.1;
constexpr SamplingReach reach{3.1 * spacing};
constexpr SamplingBox whole{0, 0, 2, 1};

double u_of(double x, double y) {
  return 1 + x - 2 * y + 0.5 * x * x - x * y + 3 * y * y;
}
double v_of(double x, double y) {
  return -2 + 3 * x + y - x * x + 2 * x * y - 0.5 * y * y;
}
double p_of(double x, double y) {
  return 4 - x + 2 * y + x * x + 0.5 * x * y - y * y;
}

/// Quadratic fields; what carries no pressure has a value there that would be noticed.
particles::ParticleSet quadratic_fields(unsigned seed) {
  auto set = disordered_vessel(2, spacing, 0.3, seed);
  for (int i = 0; i < set.size(); ++i) {
    set.u[i] = u_of(set.x[i], set.y[i]);
    set.v[i] = v_of(set.x[i], set.y[i]);
    set.p[i] = i < set.pressure_end() ? p_of(set.x[i], set.y[i]) : 1e6;
  }
  return set;
}

TEST(Sampler, IsExactForQuadraticsInTheFluidAndOnTheWalls) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto set = quadratic_fields(seed);
    const Sampler sampler(set, reach, whole);
    for (const double x : {0.0, 0.31, 1.0, 1.77, 2.0}) {
      for (const double y : {0.0, 0.01, 0.2, 0.5, 0.93, 1.0}) {
        const Velocity velocity = sampler.velocity(x, y);
        ASSERT_NEAR(velocity.u, u_of(x, y), 1e-9) << x << ", " << y << ", seed " << seed;
        ASSERT_NEAR(velocity.v, v_of(x, y), 1e-9) << x << ", " << y << ", seed " << seed;
        ASSERT_NEAR(sampler.pressure(x, y), p_of(x, y), 1e-9) << x << ", " << y << ", seed " << seed;
      }
    }
  }
}

TEST(Sampler, DoesNotDependOnTheBoxItWasMadeFor) {
  const auto set = quadratic_fields(3);
  const Sampler sampler(set, reach, whole);
  const double x = 0.83, y = 0.37;
  const Sampler about_the_point(set, reach, {x, y, x, y});
  EXPECT_NEAR(about_the_point.velocity(x, y).u, sampler.velocity(x, y).u, 1e-12);
  EXPECT_NEAR(about_the_point.pressure(x, y), sampler.pressure(x, y), 1e-12);
}

TEST(Sampler, TakesTheMeanWhereParticlesCarryNoQuadratic) {
  using particles::Group;
  particles::ParticleSet set;
  for (int k = -3; k <= 3; ++k) set.p[set.add(Group::fluid, 1 + k * spacing, 0.5)] = 5 + k;
  sort_particles(set, spacing);
  EXPECT_NEAR(Sampler(set, reach, whole).pressure(1, 0.5), 5, 1e-12);
}

TEST(Sampler, WhereThereIsNothingThereIsZero) {
  const auto set = quadratic_fields(1);
  const Sampler sampler(set, reach, {50, 0, 50, 1});
  EXPECT_EQ(sampler.velocity(50, 0.5).u, 0);
  EXPECT_EQ(Sampler({}, reach, whole).pressure(1, 0.5), 0);
}

TEST(Sampler, FindsImagesAcrossThePeriods) {
  using particles::Group;
  constexpr double period = 1;
  const auto wave = [](double x, double y) {
    return std::sin(2 * std::numbers::pi * x) * std::cos(2 * std::numbers::pi * y);
  };
  particles::ParticleSet set;
  for (int a = 0; a < 10; ++a) {
    for (int b = 0; b < 10; ++b) {
      // Some went around and were not put back, as the nodes of a cell are not.
      const double rounds = (a + b) % 3;
      const int i = set.add(Group::fluid, (a + 0.5) * spacing + 2 * rounds, (b + 0.5) * spacing - rounds);
      set.u[i] = wave(set.x[i], set.y[i]);
    }
  }
  sort_particles(set, spacing);
  const Sampler sampler(set, {3.1 * spacing, period, period}, {0, 0, 1, 1});
  // A quadratic over a third of a wavelength is the wave within a few percent.
  EXPECT_NEAR(sampler.velocity(0.25, 0).u, 1, 0.05);
  for (const double x : {-1.75, 0.25, 1.25, 7.25}) {
    EXPECT_NEAR(sampler.velocity(x, 3).u, sampler.velocity(0.25, 0).u, 1e-9) << x;
  }
  // The wave is odd in x, and the lattice symmetric about 0.
  EXPECT_NEAR(sampler.velocity(0, 0).u, 0, 1e-12);
  EXPECT_NEAR(sampler.velocity(0.03, 0.95).u, -sampler.velocity(-0.03, 0.95).u, 1e-12);
}

}  // namespace
}  // namespace rouleau::operators
