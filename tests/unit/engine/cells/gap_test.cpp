#include "engine/cells/gap.h"

#include <limits>

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "tests/unit/engine/cells/analytic_rings.h"

namespace rouleau::cells {
namespace {

double gap_of(const Nodes& a, const Nodes& b) {
  return least_gap(LinkBoxes(a.ring()), LinkBoxes(b.ring()));
}

const Nodes square{{0, 2, 2, 0}, {0, 0, 2, 2}};

TEST(LeastGap, IsFromSegmentToSegment) {
  EXPECT_DOUBLE_EQ(gap_of(square, turned(square, 0, 3, 0.5)), 1);  // of two sides that face one another
  EXPECT_DOUBLE_EQ(gap_of(square, turned(square, 0, 5, 6)), 5);    // of two corners
  // A corner and the middle of a side, whichever comes first.
  const Nodes diamond = turned(square, 45, 2.5 + std::sqrt(2.0), 1 - std::sqrt(2.0));
  EXPECT_NEAR(gap_of(square, diamond), 0.5, 1e-12);
  EXPECT_NEAR(gap_of(diamond, square), 0.5, 1e-12);
}

TEST(LeastGap, IsThatOfEveryPairLookedAt) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Nodes a = random_ring(seed), b = random_ring(seed + 500);
    if (find_crossing(LinkBoxes(a.ring()), LinkBoxes(b.ring()))) continue;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.x.size(); ++i)
      least = std::min(least, nearest(b.ring(), a.x[i], a.y[i]).distance);
    for (std::size_t i = 0; i < b.x.size(); ++i)
      least = std::min(least, nearest(a.ring(), b.x[i], b.y[i]).distance);
    EXPECT_NEAR(gap_of(a, b), least, 1e-12 * least);
  }
}

TEST(WallGap, SeesWhatStandsBetweenTwoNodes) {
  Case scene;
  scene.vessel = {80e-6, 10e-6};
  scene.thrombi = {{Wall::lower, 40e-6, 3e-6}};
  const geometry::Outline outline(scene, 1e-6, 1);
  EXPECT_NEAR(wall_gap(turned(flat_ellipse(2, 1), 0, 20, 4).ring(), outline), 3, 1e-12);
  EXPECT_NEAR(wall_gap(turned(flat_ellipse(2, 1), 0, 20, 7.5).ring(), outline), 1.5, 1e-12);
  // A plate whose corners stand away from the thrombus on both sides.
  const Nodes plate{{30, 50, 50, 30}, {4, 4, 6, 6}};
  EXPECT_NEAR(wall_gap(plate.ring(), outline), 1, 1e-12);
  EXPECT_LT(wall_gap(turned(plate, 0, 0, -5).ring(), outline), 0);
}

TEST(WallGap, SeesTheImageOfAThrombus) {
  Case scene;
  scene.vessel = {80e-6, 10e-6};
  scene.vessel.ends = Ends::periodic;
  scene.thrombi = {{Wall::lower, 4e-6, 3e-6}};
  const geometry::Outline outline(scene, 1e-6, 1);
  const Nodes plate{{-6, 14, 14, -6}, {4, 4, 6, 6}};
  for (const double away : {-80.0, 0.0, 80.0}) {
    EXPECT_NEAR(wall_gap(turned(plate, 0, away, 0).ring(), outline), 1, 1e-12) << away;
  }
}

TEST(Crossing, IsFoundBetweenTwoRings) {
  const LinkBoxes here(square.ring());
  const Nodes apart = turned(square, 0, 2.01, 0), across = turned(square, 0, 1.5, 1);
  EXPECT_FALSE(find_crossing(here, LinkBoxes(apart.ring())));
  const auto crossing = find_crossing(here, LinkBoxes(across.ring()));
  ASSERT_TRUE(crossing);
  EXPECT_TRUE((crossing->x == 2 && crossing->y == 1) || (crossing->x == 1.5 && crossing->y == 2));
}

TEST(Crossing, OfARingWithItselfIsNotThatOfNeighbours) {
  for (std::uint32_t seed = 0; seed < 50; ++seed)
    EXPECT_FALSE(find_crossing(LinkBoxes(random_ring(seed).ring())));
  const Nodes eight = ring_of(41, [](double t) { return std::array{std::sin(t), std::sin(2 * t)}; });
  const auto crossing = find_crossing(LinkBoxes(eight.ring()));
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->x, 0, 0.05);
  EXPECT_NEAR(crossing->y, 0, 0.05);
}

}  // namespace
}  // namespace rouleau::cells
