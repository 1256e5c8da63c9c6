#include "engine/case/cell_envelope.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace rouleau::testing {
namespace {

double length(const Capsule& capsule) {
  return std::hypot(capsule.to[0] - capsule.from[0], capsule.to[1] - capsule.from[1]) + 2 * capsule.radius;
}

TEST(CellEnvelope, HoldsTheRestShapesThatWereComputed) {
  // Rest shapes at fill 0.5: 8.683 x 2.2915 um stiff in stretch, 7.53 x 2.38 um with the published moduli.
  const Capsule capsule = cell_envelope({.x = 0, .y = 0, .diameter = 6.36e-6, .fill = 0.5});
  EXPECT_GE(length(capsule), 8.683e-6);
  EXPECT_LE(length(capsule), 8.8e-6);
  EXPECT_GE(2 * capsule.radius, 2.38e-6);
  EXPECT_LE(2 * capsule.radius, 2.5e-6);
}

TEST(CellEnvelope, LiesAsTheCellDoes) {
  const Capsule capsule = cell_envelope({.x = 10e-6, .y = 4e-6, .angle = 30});
  EXPECT_NEAR((capsule.from[0] + capsule.to[0]) / 2, 10e-6, 1e-15);
  EXPECT_NEAR((capsule.from[1] + capsule.to[1]) / 2, 4e-6, 1e-15);
  EXPECT_NEAR((capsule.to[1] - capsule.from[1]) / (capsule.to[0] - capsule.from[0]), 1 / std::sqrt(3.0),
              1e-12);
}

TEST(CellEnvelope, ShrinksToTheCircleAsTheCellFills) {
  double longest = 1;
  for (const double fill : {0.4, 0.5, 0.65, 0.8, 0.925, 0.97, 0.985, 0.995}) {
    const double now = length(cell_envelope({.diameter = 6e-6, .fill = fill}));
    EXPECT_LT(now, longest) << fill;
    longest = now;
  }
  const Capsule circle = cell_envelope({.diameter = 6e-6, .fill = 1});
  EXPECT_NEAR(circle.radius, 3e-6, 1e-15);
  EXPECT_NEAR(length(circle), 6e-6, 1e-15);
}

TEST(CellEnvelope, DistancesBetweenAxes) {
  const Capsule flat{{0, 0}, {4, 0}, 1};
  EXPECT_DOUBLE_EQ(axis_distance(flat, std::array{2.0, 3.0}), 3);
  EXPECT_DOUBLE_EQ(axis_distance(flat, std::array{7.0, 4.0}), 5);
  EXPECT_DOUBLE_EQ(axis_distance(flat, Capsule{{1, 2}, {3, 5}, 1}), 2);
  EXPECT_DOUBLE_EQ(axis_distance(flat, Capsule{{2, -1}, {2, 1}, 1}), 0);
  EXPECT_DOUBLE_EQ(axis_distance(flat, Capsule{{6, -1}, {6, 1}, 1}), 2);
  const Capsule point{{0, 3}, {0, 3}, 1};
  EXPECT_DOUBLE_EQ(axis_distance(point, flat), 3);
  EXPECT_DOUBLE_EQ(axis_distance(point, std::array{4.0, 0.0}), 5);
}

}  // namespace
}  // namespace rouleau::testing
