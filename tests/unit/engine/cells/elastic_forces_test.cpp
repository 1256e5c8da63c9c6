#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/cells/bending.h"
#include "engine/cells/hinge.h"
#include "engine/cells/link.h"
#include "engine/cells/stretch.h"
#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {
namespace {

constexpr Material material{3.0, 0.7, 0.5};

struct Energy {
  const char* name;
  double (*energy)(Ring, const Material&);
  void (*add_forces)(Ring, const Material&, std::span<double>, std::span<double>);
};

class ElasticForces : public testing::TestWithParam<Energy> {
 protected:
  static Nodes forces(Ring ring) {
    Nodes result{std::vector<double>(ring.size(), 0.0), std::vector<double>(ring.size(), 0.0)};
    GetParam().add_forces(ring, material, result.x, result.y);
    return result;
  }
};

double largest(const std::vector<double>& values) {
  return std::fabs(*std::ranges::max_element(values, {}, [](double value) { return std::fabs(value); }));
}

TEST_P(ElasticForces, AreMinusTheGradientOfTheEnergy) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Nodes nodes = random_ring(seed);
    const Nodes force = forces(nodes.ring());
    const double scale = std::max(largest(force.x), largest(force.y));
    const auto slope = [&](double& coordinate) {
      const double step = 1e-6, middle = coordinate;
      coordinate = middle + step;
      const double above = GetParam().energy(nodes.ring(), material);
      coordinate = middle - step;
      const double below = GetParam().energy(nodes.ring(), material);
      coordinate = middle;
      return (above - below) / (2.0 * step);
    };
    for (std::size_t i = 0; i < nodes.x.size(); ++i) {
      ASSERT_NEAR(force.x[i], -slope(nodes.x[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
      ASSERT_NEAR(force.y[i], -slope(nodes.y[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
    }
  }
}

struct Resultant {
  double fx = 0, fy = 0, torque = 0;
  double scale = 0;  ///< sum of the forces' magnitudes
};

Resultant resultant(const Nodes& nodes, const Nodes& force) {
  Resultant sum;
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    sum.fx += force.x[i];
    sum.fy += force.y[i];
    sum.torque += nodes.x[i] * force.y[i] - nodes.y[i] * force.x[i];
    sum.scale += std::hypot(force.x[i], force.y[i]);
  }
  return sum;
}

TEST_P(ElasticForces, AddUpToNoForceAndNoTorque) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Nodes nodes = random_ring(seed), force = forces(nodes.ring());
    const auto [fx, fy, torque, scale] = resultant(nodes, force);
    ASSERT_GT(scale, 0.0);
    EXPECT_NEAR(fx, 0.0, 1e-13 * scale);
    EXPECT_NEAR(fy, 0.0, 1e-13 * scale);
    EXPECT_NEAR(torque, 0.0, 1e-11 * scale);
  }
}

TEST_P(ElasticForces, AreAddedToWhatIsThere) {
  const Nodes nodes = random_ring(1), once = forces(nodes.ring());
  Nodes twice = once;
  GetParam().add_forces(nodes.ring(), material, twice.x, twice.y);
  for (std::size_t i = 0; i < nodes.x.size(); ++i) EXPECT_DOUBLE_EQ(twice.x[i], 2.0 * once.x[i]);
}

INSTANTIATE_TEST_SUITE_P(Cells, ElasticForces,
                         testing::Values(Energy{"Stretch", stretch_energy, add_stretch_forces},
                                         Energy{"Bending", bending_energy, add_bending_forces}),
                         [](const auto& instance) { return instance.param.name; });

/// Links of one length that turn by 120 degrees at nodes 0 and 2, on the x axis, and by 60 at the others.
Nodes rhombus(double link) {
  const double half_length = link * std::sqrt(3.0) / 2.0;
  return {{half_length, 0.0, -half_length, 0.0}, {0.0, link / 2.0, 0.0, -link / 2.0}};
}

TEST(PrintedBending, HasTheForcesOfEquationElevenHoweverLongTheLinks) {
  const double rest = material.rest_length, spring = 2.0 * material.bend_modulus / (rest * rest);
  for (const double link : {1.0, 3.0}) {
    const Nodes nodes = rhombus(link * rest);
    Nodes printed{std::vector<double>(4, 0.0), std::vector<double>(4, 0.0)}, conservative = printed;
    add_printed_bending_forces(nodes.ring(), material, printed.x, printed.y);
    add_bending_forces(nodes.ring(), material, conservative.x, conservative.y);
    // The links' outward normals at node 0 are 60 degrees off the x axis and add up to one along it.
    EXPECT_NEAR(printed.x[0], -spring * (std::sqrt(3.0) - 1.0 / std::sqrt(3.0)), 1e-12);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(printed.x[i], link * conservative.x[i], 1e-12);
      EXPECT_NEAR(printed.y[i], link * conservative.y[i], 1e-12);
    }
  }
}

TEST(PrintedBending, AddsUpToNoForceButToATorque) {
  double largest_torque = 0.0;
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Nodes nodes = random_ring(seed);
    Nodes force{std::vector<double>(nodes.x.size(), 0.0), std::vector<double>(nodes.x.size(), 0.0)};
    add_printed_bending_forces(nodes.ring(), material, force.x, force.y);
    const auto [fx, fy, torque, scale] = resultant(nodes, force);
    EXPECT_NEAR(fx, 0.0, 1e-13 * scale);
    EXPECT_NEAR(fy, 0.0, 1e-13 * scale);
    largest_torque = std::max(largest_torque, std::fabs(torque) / scale);
  }
  EXPECT_GT(largest_torque, 1e-3);
}

TEST(LinkLaw, IsEquationTenUntilTheLinkIsCrushed) {
  EXPECT_DOUBLE_EQ(link_law(0.6, material).tension, 3.0 * 0.2);
  EXPECT_DOUBLE_EQ(link_law(0.45, material).tension, -3.0 * 0.1);
  EXPECT_NEAR(link_law(0.35, material).tension, -3.0 * (0.3 + 10.0 * 0.1), 1e-12);
  EXPECT_NEAR(link_law(0.35, {3.0, 0.7, 0.5, 0.0}).tension, -3.0 * 0.3, 1e-12);
}

TEST(HingeLaw, IsEquationElevenAtSmallAndLargeAngles) {
  const double unit = material.bend_modulus / material.rest_length;
  EXPECT_NEAR(hinge_law(1e-4, material).energy, unit * 1e-8 / 2.0, 1e-16);
  EXPECT_NEAR(hinge_law(2.0, material).moment, 2.0 * unit * std::tan(1.0), 1e-12);
  EXPECT_NEAR(hinge_law(-2.0, material).moment, -2.0 * unit * std::tan(1.0), 1e-12);
  EXPECT_NEAR(hinge_law(2.0, material).energy, -4.0 * unit * std::log(std::cos(1.0)), 1e-12);
}

TEST(HingeLaw, GoesOnSmoothlyWhereTheRingFolds) {
  const double step = 1e-6;
  for (const double angle : {-3.1, -2.8, -1.0, 2.7, 2.8, 2.9, 3.14159}) {
    const HingeLaw below = hinge_law(angle - step, material), above = hinge_law(angle + step, material);
    const HingeLaw law = hinge_law(angle, material);
    EXPECT_NEAR((above.energy - below.energy) / (2.0 * step), law.moment, 1e-7 * std::fabs(law.moment));
    EXPECT_NEAR((above.moment - below.moment) / (2.0 * step), law.slope, 1e-4 * law.slope);
  }
  EXPECT_LT(hinge_law(3.14159265, material).moment, 2.1 * hinge_law(2.8, material).moment);
}

}  // namespace
}  // namespace rouleau::cells
