#include "engine/linear/aggregates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace rouleau::linear {
namespace {

struct Points {
  std::vector<double> x, y;
};

/// A lattice of spacing 1 over `width` x `height`, shaken, without what `keep` refuses.
template <class Keep>
Points lattice(int width, int height, const Keep& keep) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shake(-0.3, 0.3);
  Points points;
  for (int a = 0; a < width; ++a) {
    for (int b = 0; b < height; ++b) {
      if (!keep(a, b)) continue;
      points.x.push_back(a + 0.5 + shake(random));
      points.y.push_back(b + 0.5 + shake(random));
    }
  }
  return points;
}

double image(double offset, double period) {
  return period > 0 ? offset - period * std::round(offset / period) : offset;
}

/// Every aggregate from 0 to count - 1 is used, and those of points within 2.1 of one another are no farther
/// apart than the bandwidth.
void expect_usable(const Points& points, const Aggregates& aggregates, double period_x, double period_y) {
  const std::set<int> used(aggregates.of.begin(), aggregates.of.end());
  EXPECT_EQ(static_cast<int>(used.size()), aggregates.count);
  EXPECT_EQ(*used.rbegin(), aggregates.count - 1);
  EXPECT_LT(aggregates.bandwidth, aggregates.count);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double r =
          std::hypot(image(points.x[i] - points.x[j], period_x), image(points.y[i] - points.y[j], period_y));
      if (r >= 2.1) continue;
      ASSERT_LE(std::abs(aggregates.of[i] - aggregates.of[j]), aggregates.bandwidth);
    }
  }
}

const auto everywhere = [](int, int) { return true; };

TEST(GridAggregates, OfAVesselHaveABandOfItsWidth) {
  for (const auto& [width, height] : {std::pair{100, 20}, {20, 100}}) {
    const Points points = lattice(width, height, everywhere);
    GridAggregates grid(5, 0, 0);
    const Aggregates& found = grid.build(points.x, points.y);
    expect_usable(points, found, 0, 0);
    EXPECT_EQ(found.count, 80);
    EXPECT_EQ(found.bandwidth, 5);
  }
}

TEST(GridAggregates, OfAPeriodicVesselHaveTwiceThatBand) {
  const Points points = lattice(100, 20, everywhere);
  GridAggregates grid(5, 100, 0);
  const Aggregates& found = grid.build(points.x, points.y);
  expect_usable(points, found, 100, 0);
  EXPECT_LE(found.bandwidth, 9);
  GridAggregates both(5, 100, 20);
  expect_usable(points, both.build(points.x, points.y), 100, 20);
  GridAggregates across(5, 0, 20);
  expect_usable(points, across.build(points.x, points.y), 0, 20);
}

TEST(GridAggregates, LeaveOutCellsWithoutPoints) {
  const Points fork = lattice(
      90, 60, [](int a, int b) { return a < 30 ? b > 20 && b < 40 : std::abs(b - 30) > (a - 30) / 3; });
  GridAggregates grid(5, 0, 0);
  const Aggregates& found = grid.build(fork.x, fork.y);
  expect_usable(fork, found, 0, 0);
  EXPECT_LT(found.count, 18 * 12);
}

TEST(GridAggregates, StrayPointsCostNoSpace) {
  Points points = lattice(10, 10, everywhere);
  points.x[3] = 1e9;
  points.y[4] = std::numeric_limits<double>::quiet_NaN();
  points.y[5] = std::numeric_limits<double>::infinity();
  GridAggregates grid(5, 0, 0);
  const Aggregates& found = grid.build(points.x, points.y);
  EXPECT_GE(found.count, 1);
  EXPECT_LE(found.count, 100);
  EXPECT_EQ(grid.build({}, {}).count, 0);
}

}  // namespace
}  // namespace rouleau::linear
