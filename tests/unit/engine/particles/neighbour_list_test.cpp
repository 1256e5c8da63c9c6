#include "engine/particles/neighbour_list.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rouleau::particles {
namespace {

constexpr Extent extent{-0.4, -0.2, 1.7, 1.1};

/// Rows of a list as sets, for comparison with every pair tried.
struct Row {
  std::set<int> near, all, ghosts;
  bool operator==(const Row&) const = default;
};

Row row_of(const NeighbourList& list, int i) {
  Row row;
  row.near.insert(list.j.begin() + list.begin(i), list.j.begin() + list.near_end(i));
  row.all.insert(list.j.begin() + list.begin(i), list.j.begin() + list.end(i));
  row.ghosts.insert(list.ghost.begin() + list.ghost_begin(i), list.ghost.begin() + list.ghost_end(i));
  return row;
}

double nearest_image(double offset, double period) {
  return period > 0 ? offset - period * std::round(offset / period) : offset;
}

/// Pairs so close to a radius that rounding decides are taken as the list has them.
Row brute_force(const ParticleSet& set, const NeighbourList& list, int i) {
  const Row found = row_of(list, i);
  Row row;
  for (int j = 0; j < set.size(); ++j) {
    if (j == i) continue;
    const double r = std::hypot(nearest_image(set.x[j] - set.x[i], list.period_x()),
                                nearest_image(set.y[j] - set.y[i], list.period_y()));
    const bool near = std::abs(r / list.near_radius() - 1) < 1e-6
                          ? found.near.count(j) || found.ghosts.count(j)
                          : r < list.near_radius();
    const bool within = std::abs(r / list.radius() - 1) < 1e-6 ? found.all.count(j) : r < list.radius();
    if (j >= set.velocity_end()) {
      if (near) row.ghosts.insert(j);
    } else if (within) {
      row.all.insert(j);
      if (near) row.near.insert(j);
    }
  }
  return row;
}

/// `spread` 1 fills the extent; more than that strays beyond it.
ParticleSet random_particles(int n, unsigned seed, double spread) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> group(0, 5);
  const double cx = (extent.x0 + extent.x1) / 2, cy = (extent.y0 + extent.y1) / 2;
  std::uniform_real_distribution<double> x(cx - spread * (cx - extent.x0), cx + spread * (cx - extent.x0));
  std::uniform_real_distribution<double> y(cy - spread * (cy - extent.y0), cy + spread * (cy - extent.y0));
  ParticleSet set;
  for (int k = 0; k < n; ++k) set.add(static_cast<Group>(group(random)), x(random), y(random));
  sort_particles(set, 0.1);
  return set;
}

TEST(NeighbourList, HoldsExactlyThePairsThatTryingAllFinds) {
  EXPECT_TRUE(rc::check([] {
    const int n = *rc::gen::inRange(0, 200);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const double radius = *rc::gen::inRange(3, 60) * 0.01;
    const double near_radius = radius * *rc::gen::inRange(1, 11) * 0.1;
    const double spread = *rc::gen::elementOf(std::vector<double>{0.1, 1, 1.5, 4});
    const ParticleSet set = random_particles(n, seed, spread);
    NeighbourList list(extent, radius, near_radius);
    list.build(set);
    RC_ASSERT(list.rows() == set.active_end());
    int longest = 0;
    for (int i = 0; i < list.rows(); ++i) {
      const Row row = row_of(list, i);
      RC_ASSERT(row == brute_force(set, list, i));
      RC_ASSERT(static_cast<int>(row.all.size()) == list.end(i) - list.begin(i));
      longest = std::max(longest, list.end(i) - list.begin(i));
    }
    RC_ASSERT(list.longest_row() == longest);
  }));
}

TEST(NeighbourList, PeriodicPairsAreThoseOfTheNearestImages) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    // Spread 1.6 reaches beyond both seams, as particles do that are not wrapped after every step.
    const ParticleSet set = random_particles(150, seed, 1.6);
    const double radius = 0.05 + 0.02 * seed;
    for (const auto& [period_x, period_y] : {std::pair{1.1, 0.0}, {0.0, 0.95}, {1.1, 0.95}}) {
      NeighbourList list(extent, radius, 0.6 * radius, period_x, period_y);
      list.build(set);
      ASSERT_GT(list.pairs(), 0);
      for (int i = 0; i < list.rows(); ++i) {
        ASSERT_EQ(row_of(list, i), brute_force(set, list, i));
        for (int k = list.begin(i); k < list.end(i); ++k) {
          const int j = list.j[k];
          ASSERT_NEAR(list.dx[k], nearest_image(set.x[j] - set.x[i], period_x), 2e-7);
          ASSERT_NEAR(list.dy[k], nearest_image(set.y[j] - set.y[i], period_y), 2e-7);
          ASSERT_NEAR(list.r[k], std::hypot(list.dx[k], list.dy[k]), 1e-7);
        }
      }
    }
  }
}

TEST(NeighbourList, APeriodOfTwoRadiiStillHoldsEveryPairOnce) {
  const ParticleSet set = random_particles(120, 9, 1);
  NeighbourList list(extent, 0.3, 0.2, 0.6, 0.61);
  list.build(set);
  for (int i = 0; i < list.rows(); ++i) {
    ASSERT_EQ(row_of(list, i), brute_force(set, list, i));
    ASSERT_EQ(static_cast<int>(row_of(list, i).all.size()), list.end(i) - list.begin(i));
  }
}

TEST(NeighbourList, OffsetsAreThoseOfThePair) {
  const ParticleSet set = random_particles(150, 3, 1);
  NeighbourList list(extent, 0.3, 0.2);
  list.build(set);
  ASSERT_GT(list.pairs(), 100);
  for (int i = 0; i < list.rows(); ++i) {
    for (int k = list.begin(i); k < list.end(i); ++k) {
      const double dx = set.x[list.j[k]] - set.x[i], dy = set.y[list.j[k]] - set.y[i];
      ASSERT_NEAR(list.dx[k], dx, 1e-7);
      ASSERT_NEAR(list.dy[k], dy, 1e-7);
      ASSERT_NEAR(list.r[k], std::hypot(dx, dy), 1e-7);
    }
    for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) {
      ASSERT_NEAR(list.ghost_dx[k], set.x[list.ghost[k]] - set.x[i], 1e-7);
      ASSERT_NEAR(list.ghost_dy[k], set.y[list.ghost[k]] - set.y[i], 1e-7);
      ASSERT_NEAR(list.ghost_r[k],
                  std::hypot(set.x[list.ghost[k]] - set.x[i], set.y[list.ghost[k]] - set.y[i]), 1e-7);
    }
  }
}

TEST(NeighbourList, PaddingIsOfPairsThatDoNothing) {
  const ParticleSet set = random_particles(150, 3, 1);
  NeighbourList list(extent, 0.3, 0.2);
  list.build(set);
  for (int i = 0; i < list.rows(); ++i) {
    ASSERT_EQ((list.padded_end(i) - list.begin(i)) % simd::lanes, 0);
    ASSERT_LT(list.padded_end(i) - list.end(i), simd::lanes);
    for (int k = list.end(i); k < list.padded_end(i); ++k) {
      ASSERT_EQ(list.j[k], i);
      ASSERT_EQ(list.dx[k], 0);
      ASSERT_EQ(list.dy[k], 0);
      ASSERT_EQ(list.r[k], 0.3F);
    }
  }
}

TEST(NeighbourList, BuildingAgainForgetsTheFirstTime) {
  NeighbourList list(extent, 0.3, 0.2);
  list.build(random_particles(300, 4, 1));
  const ParticleSet set = random_particles(40, 5, 1);
  list.build(set);
  ASSERT_EQ(list.rows(), set.active_end());
  for (int i = 0; i < list.rows(); ++i) ASSERT_EQ(row_of(list, i), brute_force(set, list, i));
}

TEST(NeighbourList, PlacesFarOutsideHaveNoNeighboursAndCostNoSpace) {
  ParticleSet set = random_particles(60, 6, 1);
  for (const double far : {1e3, 1e12, 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    set.add(Group::fluid, far, 0.5);
    set.add(Group::fluid, 0.5, -far);
  }
  sort_particles(set, 0.1);
  NeighbourList list(extent, 0.3, 0.2);
  list.build(set);
  for (int i = 0; i < list.rows(); ++i) {
    const bool strayed = std::abs(set.x[i]) > 100 || std::abs(set.y[i]) > 100;
    if (strayed) {
      ASSERT_EQ(list.begin(i), list.end(i));
    } else {
      ASSERT_EQ(row_of(list, i), brute_force(set, list, i));
    }
  }
}

TEST(NeighbourList, APositionThatIsNoNumberIsNobodysNeighbour) {
  ParticleSet particles;
  particles.add(Group::fluid, 0.5, 0.5);
  particles.add(Group::fluid, std::nan(""), 0.5);
  sort_particles(particles, 0.1);
  NeighbourList list({-0.4, -0.2, 1.7, 1.1}, 0.3, 0.2);
  list.build(particles);
  EXPECT_EQ(list.pairs(), 0);
}

TEST(NeighbourList, ParticlesInOnePlaceAreNeighbours) {
  ParticleSet set;
  for (int k = 0; k < 3; ++k) set.add(Group::fluid, 0.5, 0.5);
  sort_particles(set, 0.1);
  NeighbourList list(extent, 0.3, 0.2);
  list.build(set);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(list.near_end(i) - list.begin(i), 2);
    ASSERT_EQ(list.r[list.begin(i)], 0);
  }
}

}  // namespace
}  // namespace rouleau::particles
