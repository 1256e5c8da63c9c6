#include "engine/operators/standard_mps.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace rouleau::operators {
namespace {

using particles::Group;
using particles::NeighbourList;
using particles::ParticleSet;

constexpr double spacing = 0.05;

/// A square lattice of `side` particles a side, ghosts in the rows below y = 0.
struct Lattice {
  explicit Lattice(double radius, int side = 13)
      : mps(spacing, radius), neighbours({-1, -1, 2, 2}, radius, radius) {
    for (int a = 0; a < side; ++a) {
      for (int b = -3; b < side; ++b) {
        set.add(b < 0 ? Group::ghost : Group::fluid, a * spacing, b * spacing);
      }
    }
    sort_particles(set, spacing);
    neighbours.build(set);
    weights.fill(mps, neighbours);
  }

  int at(int a, int b) const {
    for (int i = 0; i < set.size(); ++i) {
      if (std::hypot(set.x[i] - a * spacing, set.y[i] - b * spacing) < 1e-9) return i;
    }
    ADD_FAILURE() << "no particle at " << a << ", " << b;
    return 0;
  }

  template <class Field>
  std::vector<double> sample(const Field& field) const {
    std::vector<double> values;
    for (int i = 0; i < set.size(); ++i) values.push_back(field(set.x[i], set.y[i]));
    return values;
  }

  StandardMps mps;
  ParticleSet set;
  NeighbourList neighbours;
  KernelWeights weights;
};

TEST(StandardMps, KernelIsRadiusOverDistanceLessOne) {
  const StandardMps mps(1, 2.1);
  EXPECT_DOUBLE_EQ(mps.weight(0.5), 3.2);
  EXPECT_DOUBLE_EQ(mps.weight(1), 1.1);
  EXPECT_NEAR(mps.weight(2.0999), 0, 1e-4);
  EXPECT_EQ(mps.weight(2.1), 0);
  EXPECT_EQ(mps.weight(3), 0);
}

// Four neighbours each at 1, sqrt(2) and 2 spacings.
TEST(StandardMps, ConstantsOfTheStudysLattice) {
  const double n0 = 4 * (2.1 - 1) + 4 * (2.1 / std::sqrt(2.0) - 1) + 4 * (2.1 / 2 - 1);
  for (const double d0 : {1.0, 0.04}) {
    const StandardMps mps(d0, 2.1 * d0);
    EXPECT_NEAR(mps.density(), n0, 1e-12);
    EXPECT_NEAR(mps.density(), 6.5397, 5e-5);
    EXPECT_NEAR(mps.square_distance(), 1.388 * d0 * d0, 5e-4 * d0 * d0);
  }
}

class StandardMpsOnALattice : public testing::TestWithParam<double> {
 protected:
  Lattice lattice_{GetParam() * spacing};
};

TEST_P(StandardMpsOnALattice, DensityIsTheLatticesAndCountsGhosts) {
  const auto density = [&](int a, int b) {
    return number_density(lattice_.neighbours, lattice_.weights, lattice_.at(a, b));
  };
  EXPECT_NEAR(density(6, 6), lattice_.mps.density(), 1e-5);
  EXPECT_NEAR(density(6, 0), lattice_.mps.density(), 1e-5);
  EXPECT_LT(density(6, 12), 0.8 * lattice_.mps.density());
}

TEST_P(StandardMpsOnALattice, GradientOfALinearFieldIsExact) {
  const auto field = lattice_.sample([](double x, double y) { return 3 + 2 * x - 5 * y; });
  const int i = lattice_.at(6, 6);
  for (const double base : {field[i], -7.0}) {
    const Gradient g = gradient(lattice_.mps, lattice_.neighbours, lattice_.weights, i, field.data(), base);
    EXPECT_NEAR(g.x, 2, 1e-4);
    EXPECT_NEAR(g.y, -5, 1e-4);
  }
}

TEST_P(StandardMpsOnALattice, DivergenceOfALinearFieldIsExact) {
  const auto u = lattice_.sample([](double x, double y) { return 1 + 2 * x - 5 * y; });
  const auto v = lattice_.sample([](double x, double y) { return 3 * x + 4 * y - 2; });
  EXPECT_NEAR(
      divergence(lattice_.mps, lattice_.neighbours, lattice_.weights, lattice_.at(6, 6), u.data(), v.data()),
      6, 1e-4);
}

TEST_P(StandardMpsOnALattice, GradientAgainstAnotherBasePushesOffTheEdge) {
  const auto field = lattice_.sample([](double, double) { return 1.0; });
  const int i = lattice_.at(12, 6);
  const auto with_base = [&](double base) {
    return gradient(lattice_.mps, lattice_.neighbours, lattice_.weights, i, field.data(), base);
  };
  EXPECT_EQ(with_base(1).x, 0);
  EXPECT_LT(with_base(0).x, -1);  // -grad p then drives it away from its neighbours
  EXPECT_NEAR(with_base(0).y, 0, 1e-4);
}

TEST_P(StandardMpsOnALattice, LaplacianOfAQuadraticFieldIsExact) {
  const auto field =
      lattice_.sample([](double x, double y) { return 4 - x + x * x + 3 * x * y + 2 * y * y; });
  for (const int row : {6, 0}) {
    const int i = lattice_.at(6, row);
    EXPECT_NEAR(laplacian(lattice_.mps, lattice_.neighbours, lattice_.weights, i, field.data()), 6, 1e-3);
  }
}

/// The spread of a single peak stays without new extremes up to the step that is named, and not beyond.
TEST_P(StandardMpsOnALattice, LargestStepIsWhereDiffusionBeginsToOvershoot) {
  const int peak = lattice_.at(6, 6);
  const double viscosity = 0.3;
  const auto after = [&](double step) {
    std::vector<double> field(lattice_.set.x.size(), 0);
    field[peak] = 1;
    return field[peak] +
           step * viscosity *
               laplacian(lattice_.mps, lattice_.neighbours, lattice_.weights, peak, field.data());
  };
  const double largest = lattice_.mps.largest_step(viscosity);
  EXPECT_NEAR(after(largest), 0, 1e-5);
  EXPECT_GT(after(0.99 * largest), 0);
  EXPECT_LT(after(1.01 * largest), 0);
}

INSTANTIATE_TEST_SUITE_P(Radii, StandardMpsOnALattice, testing::Values(2.1, 3.1));

}  // namespace
}  // namespace rouleau::operators
