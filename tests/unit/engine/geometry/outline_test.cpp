#include "engine/geometry/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/engine/geometry/vessels.h"

namespace rouleau::geometry {
namespace {

constexpr double length = 4, height = 1;

/// One thrombus a wall, and a second one downstream on the lower wall.
std::vector<Thrombus> some_thrombi() {
  return {{Wall::lower, 2.9, 0.2}, {Wall::lower, 1.1, 0.35}, {Wall::upper, 1.3, 0.25}};
}

double wall_y(const Thrombus& t) {
  return t.wall == Wall::lower ? 0 : height;
}

/// A wall sampled at `step`, by nothing but its description.
std::vector<Point> sample_wall(const std::vector<Thrombus>& thrombi, double y, double step) {
  std::vector<Point> points;
  for (double x = -1; x <= length + 1; x += step) {
    const bool under_thrombus = std::any_of(thrombi.begin(), thrombi.end(), [&](const Thrombus& t) {
      return wall_y(t) == y && std::abs(x - t.x) < t.radius;
    });
    if (!under_thrombus) points.push_back({x, y});
  }
  const double up = y == 0 ? 1 : -1;
  for (const Thrombus& t : thrombi) {
    if (wall_y(t) != y) continue;
    for (double angle = 0; angle <= std::numbers::pi; angle += step / t.radius) {
      points.push_back({t.x + t.radius * std::cos(angle), y + up * t.radius * std::sin(angle)});
    }
  }
  return points;
}

double nearest_of(const std::vector<Point>& points, const Point& to) {
  double least2 = std::numeric_limits<double>::infinity();
  for (const Point& p : points) {
    const double dx = p[0] - to[0], dy = p[1] - to[1];
    least2 = std::min(least2, dx * dx + dy * dy);
  }
  return std::sqrt(least2);
}

bool in_fluid(const std::vector<Thrombus>& thrombi, const Point& p) {
  return p[1] > 0 && p[1] < height && std::none_of(thrombi.begin(), thrombi.end(), [&](const Thrombus& t) {
           return std::hypot(p[0] - t.x, p[1] - wall_y(t)) <= t.radius;
         });
}

TEST(Outline, DistanceIsThatToTheNearestPointOfTheWalls) {
  const auto thrombi = some_thrombi();
  const Outline outline = outline_of(straight_vessel(length, height, thrombi));
  constexpr double step = 2e-4;
  auto wall = sample_wall(thrombi, 0, step);
  const auto upper = sample_wall(thrombi, 1, step);
  wall.insert(wall.end(), upper.begin(), upper.end());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(0, length), across(0, height);
  int checked = 0;
  while (checked < 300) {
    const Point p{along(random), across(random)};
    if (!in_fluid(thrombi, p)) continue;
    const double brute = nearest_of(wall, p);
    if (brute < 0.02) continue;  // nearer than this the sampling itself is off by more than the tolerance
    ++checked;
    const WallDistance distance = outline.distance(p[0], p[1]);
    ASSERT_NEAR(distance.value, brute, 1e-6) << "at " << p[0] << ", " << p[1];
    ASSERT_NEAR(std::hypot(distance.nx, distance.ny), 1, 1e-12);
    const Point foot{p[0] - distance.value * distance.nx, p[1] - distance.value * distance.ny};
    ASSERT_LT(nearest_of(wall, foot), step) << "the normal does not lead away from the wall";
  }
}

TEST(Outline, DistanceIsNegativeBehindTheWallsAndLeadsOut) {
  const Outline outline = outline_of(straight_vessel(length, height, some_thrombi()));
  const WallDistance below = outline.distance(0.3, -0.05), above = outline.distance(0.3, 1.02);
  EXPECT_NEAR(below.value, -0.05, 1e-15);
  EXPECT_EQ(below.ny, 1);
  EXPECT_NEAR(above.value, -0.02, 1e-15);
  EXPECT_EQ(above.ny, -1);
  const double angle = 1.1, depth = 0.03;
  const WallDistance inside =
      outline.distance(1.1 + (0.35 - depth) * std::cos(angle), (0.35 - depth) * std::sin(angle));
  EXPECT_NEAR(inside.value, -depth, 1e-12);
  EXPECT_NEAR(inside.nx, std::cos(angle), 1e-12);
  EXPECT_NEAR(inside.ny, std::sin(angle), 1e-12);
}

TEST(Outline, NarrowestIsTheLeastGapBetweenTheWalls) {
  const std::vector<std::vector<Thrombus>> scenes = {
      {},
      {{Wall::lower, 1.5, 0.4}},
      {{Wall::upper, 1.5, 0.6}},
      {{Wall::lower, 1.5, 0.3}, {Wall::upper, 1.5, 0.4}},   // opposite
      {{Wall::lower, 1.5, 0.45}, {Wall::upper, 1.9, 0.4}},  // staggered: the gap is aslant
      {{Wall::lower, 1.0, 0.3}, {Wall::upper, 3.0, 0.35}},  // too far apart to matter to each other
      some_thrombi(),
  };
  for (const auto& thrombi : scenes) {
    const auto lower = sample_wall(thrombi, 0, 4e-3), upper = sample_wall(thrombi, 1, 4e-3);
    double brute = height;
    for (const Point& p : lower) brute = std::min(brute, nearest_of(upper, p));
    EXPECT_NEAR(outline_of(straight_vessel(length, height, thrombi)).narrowest(), brute, 1e-4);
  }
}

TEST(Outline, NarrowestOfOppositeBumpsIsWhatTheyLeaveOpen) {
  EXPECT_DOUBLE_EQ(
      outline_of(straight_vessel(length, height, {{Wall::lower, 2, 0.25}, {Wall::upper, 2, 0.5}}))
          .narrowest(),
      0.25);
}

class WallNodes : public testing::TestWithParam<double> {
 protected:
  const Outline outline_ = outline_of(straight_vessel(length, height, some_thrombi()));
  const std::vector<WallNode> nodes_ = outline_.wall_nodes(GetParam(), 0.3);
};

TEST_P(WallNodes, LieOnTheSurface) {
  for (const WallNode& node : nodes_) {
    ASSERT_NEAR(outline_.distance(node.x, node.y).value, 0, 1e-12) << "at " << node.x << ", " << node.y;
  }
}

TEST_P(WallNodes, AreEvenlySpacedAlongEachWall) {
  const double spacing = GetParam();
  int gaps = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    if (std::abs(nodes_[k].y - nodes_[k - 1].y) > 0.9) continue;  // on to the other wall
    const double gap = std::hypot(nodes_[k].x - nodes_[k - 1].x, nodes_[k].y - nodes_[k - 1].y);
    ASSERT_NEAR(gap, spacing, 0.2 * spacing) << "at " << nodes_[k].x << ", " << nodes_[k].y;
    ++gaps;
  }
  EXPECT_EQ(gaps, static_cast<int>(nodes_.size()) - 2);
}

TEST_P(WallNodes, StandInEveryCornerOnceAndReachBeyondBothEnds) {
  for (const Thrombus& t : some_thrombi()) {
    for (const double side : {-1.0, 1.0}) {
      const double x = t.x + side * t.radius;
      const auto at_corner = std::count_if(nodes_.begin(), nodes_.end(), [&](const WallNode& n) {
        return std::hypot(n.x - x, n.y - wall_y(t)) < 1e-12;
      });
      EXPECT_EQ(at_corner, 1) << "corner at " << x << ", " << wall_y(t);
    }
  }
  const auto [first, last] = std::minmax_element(
      nodes_.begin(), nodes_.end(), [](const WallNode& a, const WallNode& b) { return a.x < b.x; });
  EXPECT_NEAR(first->x, -0.3, 1e-12);
  EXPECT_GT(last->x, length + 0.3 - 1.5 * GetParam());
}

TEST_P(WallNodes, HaveUnitNormalsIntoTheFluid) {
  for (const WallNode& node : nodes_) {
    ASSERT_NEAR(std::hypot(node.nx, node.ny), 1, 1e-12);
    ASSERT_GT(outline_.distance(node.x + 1e-3 * node.nx, node.y + 1e-3 * node.ny).value, 5e-4)
        << "at " << node.x << ", " << node.y;
  }
}

INSTANTIATE_TEST_SUITE_P(Spacings, WallNodes, testing::Values(0.05, 0.04, 0.025, 0.013));

TEST(Outline, WallNodesOfNearlyTouchingBumpsLieOnTheSurfaceOnce) {
  const double spacing = 0.05;
  for (const double gap : {0.0, 0.5 * spacing, spacing, 1.4 * spacing}) {
    const Outline outline =
        outline_of(straight_vessel(4, 1, {{Wall::lower, 1, 0.3}, {Wall::lower, 1.6 + gap, 0.3}}));
    const auto nodes = outline.wall_nodes(spacing, 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_NEAR(outline.distance(nodes[i].x, nodes[i].y).value, 0, 1e-12) << "gap " << gap;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GT(std::hypot(nodes[i].x - nodes[k].x, nodes[i].y - nodes[k].y), 0.1 * spacing)
            << "gap " << gap;
      }
    }
  }
}

TEST(Outline, HasImagesWhereItRepeats) {
  const auto images = [](const Case& scene) {
    std::vector<Point> found;
    outline_of(scene).visit_images([&](double dx, double dy) { found.push_back({dx, dy}); });
    return found;
  };
  Case scene = straight_vessel(4, 1);
  EXPECT_TRUE(images(scene).empty());
  scene.vessel.ends = Ends::periodic;
  EXPECT_EQ(images(scene), (std::vector<Point>{{-4, 0}, {4, 0}}));
  scene.vessel.shape = Shape::box;
  const auto around = images(scene);
  EXPECT_EQ(std::set<Point>(around.begin(), around.end()).size(), 8u);
  EXPECT_EQ(std::count(around.begin(), around.end(), Point{4, -1}), 1);
  EXPECT_EQ(std::count(around.begin(), around.end(), Point{0, 0}), 0);
}

TEST(Outline, WallNodesOfAPlainVesselAreTwoStraightRows) {
  const auto nodes = outline_of(straight_vessel(2, 1)).wall_nodes(0.1, 0);
  ASSERT_EQ(nodes.size(), 42u);
  EXPECT_EQ(nodes[0].y, 0);
  EXPECT_EQ(nodes[21].y, 1);
  EXPECT_NEAR(nodes[7].x, 0.7, 1e-12);
}

}  // namespace
}  // namespace rouleau::geometry
