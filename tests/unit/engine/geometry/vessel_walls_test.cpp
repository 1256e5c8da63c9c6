#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/unit/engine/geometry/vessels.h"

namespace rouleau::geometry {
namespace {

std::vector<Case> vessels() {
  Case periodic = straight_vessel(3, 1, {{Wall::lower, 0.1, 0.3}, {Wall::upper, 1.4, 0.25}});
  periodic.vessel.ends = Ends::periodic;
  return {straight_vessel(4, 1, {{Wall::lower, 1.1, 0.35}, {Wall::upper, 1.3, 0.25}}), periodic,
          box(2, 1, Ends::closed), bifurcation(), uneven_bifurcation()};
}

/// Somewhere in the bounds or up to 0.2 outside of them.
Point any_place(const Outline& outline) {
  const Bounds b = outline.bounds();
  const auto within = [](double from, double to) {
    return from - 0.2 + (to - from + 0.4) * *rc::gen::inRange(0, 1'000'000) / 1e6;
  };
  const double x = within(b.x0, b.x1);
  return {x, within(b.y0, b.y1)};
}

TEST(VesselWalls, DistanceChangesByNoMoreThanTheWay) {
  for (const Case& scene : vessels()) {
    const Outline outline = outline_of(scene);
    EXPECT_TRUE(rc::check([&] {
      const Point a = any_place(outline), b = any_place(outline);
      const double change = outline.distance(a[0], a[1]).value - outline.distance(b[0], b[1]).value;
      RC_ASSERT(std::abs(change) <= std::hypot(a[0] - b[0], a[1] - b[1]) + 1e-12);
    }));
  }
}

// With the test before: no wall is nearer than the distance says.
TEST(VesselWalls, NormalLeadsFromTheWall) {
  for (const Case& scene : vessels()) {
    const Outline outline = outline_of(scene);
    EXPECT_TRUE(rc::check([&] {
      const Point p = any_place(outline);
      const WallDistance d = outline.distance(p[0], p[1]);
      RC_ASSERT(std::abs(std::hypot(d.nx, d.ny) - 1) < 1e-12);
      const WallDistance foot = outline.distance(p[0] - d.value * d.nx, p[1] - d.value * d.ny);
      if (d.value > 0) RC_ASSERT(std::abs(foot.value) < 1e-12);
    }));
  }
}

TEST(VesselWalls, NormalIsTheGradientOfTheDistance) {
  constexpr double step = 1e-6;
  for (const Case& scene : vessels()) {
    const Outline outline = outline_of(scene);
    int smooth = 0;
    EXPECT_TRUE(rc::check([&] {
      const auto [x, y] = any_place(outline);
      const auto at = [&](double dx, double dy) { return outline.distance(x + dx, y + dy); };
      const WallDistance d = at(0, 0);
      // Between two walls as near, and in the middle of a thrombus, the normal jumps.
      for (const auto& [dx, dy] : {Point{step, 0}, Point{-step, 0}, Point{0, step}, Point{0, -step}}) {
        if (std::hypot(at(dx, dy).nx - d.nx, at(dx, dy).ny - d.ny) > 1e-3) return;
      }
      ++smooth;
      RC_ASSERT(std::abs((at(step, 0).value - at(-step, 0).value) / (2 * step) - d.nx) < 1e-4);
      RC_ASSERT(std::abs((at(0, step).value - at(0, -step).value) / (2 * step) - d.ny) < 1e-4);
    }));
    EXPECT_GT(smooth, 80);
  }
}

/// Whether a ray from the point crosses the polygon an odd number of times.
bool in_polygon(const std::vector<Point>& corners, const Point& p) {
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % corners.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if (p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

// 80 by 20 um, branches of 40 by 10 um at 30 degrees; here in trunk diameters.
TEST(Bifurcation, OfTheStudyHasItsCornersWhereTheyAreDrawn) {
  const Outline outline = outline_of(bifurcation());
  const double c = std::sqrt(3) / 2, s = 0.5;
  const Point apex{4 + 0.1339745962155614, 0.5};
  const Point lower_outer{4 + 2 * c, -2 * s}, lower_inner{lower_outer[0] + s / 2, lower_outer[1] + c / 2};
  const std::vector<Point> corners = {{0, 0},
                                      {4, 0},
                                      lower_outer,
                                      lower_inner,
                                      apex,
                                      {lower_inner[0], 1 - lower_inner[1]},
                                      {lower_outer[0], 1 - lower_outer[1]},
                                      {4, 1},
                                      {0, 1}};
  for (const Point& corner : {Point{4, 0}, apex, Point{4, 1}}) {
    EXPECT_NEAR(outline.distance(corner[0], corner[1]).value, 0, 1e-14);
    EXPECT_EQ(std::ranges::count_if(
                  outline.wall_nodes(0.05, 0.3),
                  [&](const WallNode& n) { return std::hypot(n.x - corner[0], n.y - corner[1]) < 1e-12; }),
              1);
  }
  double twice_area = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % corners.size()];
    twice_area += a[0] * b[1] - b[0] * a[1];
  }
  EXPECT_NEAR(outline.area(), twice_area / 2, 1e-13);
  EXPECT_TRUE(rc::check([&] {
    const Point p = any_place(outline);
    RC_ASSERT(outline.contains(p[0], p[1]) == in_polygon(corners, p));
  }));
  EXPECT_DOUBLE_EQ(outline.narrowest(), 0.5);
  EXPECT_NEAR(outline.bounds().x1, lower_inner[0], 1e-14);
  EXPECT_NEAR(outline.bounds().y0, lower_outer[1], 1e-14);
}

TEST(Bifurcation, ApexPushesAlongTheWayFromIt) {
  const Outline outline = outline_of(bifurcation());
  const double apex = 4 + 0.1339745962155614;
  const WallDistance ahead = outline.distance(apex - 0.1, 0.5 + 0.03);
  EXPECT_NEAR(ahead.value, std::hypot(0.1, 0.03), 1e-12);
  EXPECT_NEAR(ahead.nx, -0.1 / ahead.value, 1e-12);
  EXPECT_NEAR(ahead.ny, 0.03 / ahead.value, 1e-12);
  const WallDistance behind = outline.distance(apex + 0.1, 0.5);
  EXPECT_NEAR(behind.value, -0.05, 1e-12);
}

TEST(Bifurcation, OpeningsStandAcrossTheBranches) {
  const Outline outline = outline_of(uneven_bifurcation());
  ASSERT_EQ(outline.inlets().size(), 1u);
  ASSERT_EQ(outline.outlets().size(), 2u);
  const Opening& inlet = outline.inlets()[0];
  EXPECT_EQ(inlet.corner, (Point{0, 0}));
  EXPECT_EQ(inlet.beyond(-0.3, 0.2), 0.3);
  EXPECT_EQ(inlet.across(-0.3, 0.2), 0.2);
  const double widths[] = {0.4, 0.55};
  for (int k = 0; k < 2; ++k) {
    const Opening& outlet = outline.outlets()[static_cast<std::size_t>(k)];
    EXPECT_DOUBLE_EQ(outlet.width, widths[k]);
    EXPECT_NEAR(outlet.tx, -outlet.ay, 1e-15);
    EXPECT_NEAR(outlet.ty, outlet.ax, 1e-15);
    EXPECT_NEAR(outlet.ay, (k == 0 ? -1 : 1) * std::sin(38 * std::numbers::pi / 180), 1e-15);
    for (const double across : {0.0, outlet.width}) {
      for (const double beyond : {0.0, 0.4}) {
        const Point p = outlet.at(across, beyond);
        EXPECT_NEAR(outline.distance(p[0], p[1]).value, 0, 1e-13) << "the walls go on straight";
        EXPECT_NEAR(outlet.across(p[0], p[1]), across, 1e-14);
        EXPECT_NEAR(outlet.beyond(p[0], p[1]), beyond, 1e-14);
      }
    }
    const Point within = outlet.at(outlet.width / 2, -1e-9), past = outlet.at(outlet.width / 2, 1e-9);
    EXPECT_TRUE(outline.contains(within[0], within[1]));
    EXPECT_FALSE(outline.contains(past[0], past[1]));
  }
}

TEST(Bifurcation, ThrombusStandsOnTheInclinedWall) {
  const Outline outline = outline_of(bifurcation({{Wall::upper, 4.9, 0.2}}));
  ASSERT_EQ(outline.bumps().size(), 1u);
  const auto [x, y] = outline.bumps()[0].centre;
  EXPECT_DOUBLE_EQ(x, 4.9);
  EXPECT_NEAR(y, 1 + 0.9 / std::sqrt(3), 1e-14);
  EXPECT_NEAR(outline_of(bifurcation()).area() - outline.area(), std::numbers::pi * 0.02, 1e-13);
  EXPECT_NEAR(outline.narrowest(), 0.3, 1e-14);
  const double c = std::sqrt(3) / 2, s = 0.5;
  EXPECT_NEAR(outline.distance(x + 0.25 * s, y - 0.25 * c).value, 0.05, 1e-13);
}

TEST(Bifurcation, OfEqualBranchesIsItsOwnMirrorImage) {
  const Outline outline = outline_of(bifurcation(
      {{Wall::lower, 1, 0.3}, {Wall::upper, 1, 0.3}, {Wall::lower, 4.8, 0.2}, {Wall::upper, 4.8, 0.2}}));
  EXPECT_TRUE(rc::check([&] {
    const auto [x, y] = any_place(outline);
    RC_ASSERT(std::abs(outline.distance(x, y).value - outline.distance(x, 1 - y).value) < 1e-13);
  }));
  const auto nodes = outline.wall_nodes(0.043, 0.2);
  for (const WallNode& node : nodes) {
    EXPECT_TRUE(std::ranges::any_of(nodes,
                                    [&](const WallNode& other) {
                                      return std::hypot(node.x - other.x, node.y + other.y - 1) < 1e-12 &&
                                             std::hypot(node.nx - other.nx, node.ny + other.ny) < 1e-12;
                                    }))
        << node.x << ", " << node.y;
  }
}

TEST(Bifurcation, NarrowestIsTheLeastOfItsParts) {
  EXPECT_DOUBLE_EQ(outline_of(bifurcation({{Wall::lower, 2, 0.7}})).narrowest(), 0.3);
  Case scene = bifurcation();
  scene.vessel.branches[1].diameter = 0.45;
  EXPECT_DOUBLE_EQ(outline_of(scene).narrowest(), 0.45);
}

TEST(Box, ClosedHasFourWallsAndPeriodicNone) {
  const Outline closed = outline_of(box(2, 1, Ends::closed));
  EXPECT_DOUBLE_EQ(closed.distance(0.1, 0.4).value, 0.1);
  EXPECT_DOUBLE_EQ(closed.distance(1.95, 0.4).nx, -1);
  EXPECT_DOUBLE_EQ(closed.distance(1, 0.8).ny, -1);
  EXPECT_DOUBLE_EQ(closed.area(), 2);
  EXPECT_TRUE(closed.inlets().empty() && closed.outlets().empty());
  EXPECT_EQ(closed.period_x(), 0);

  const Outline periodic = outline_of(box(2, 1, Ends::periodic));
  EXPECT_EQ(periodic.distance(0.1, 0.4).value, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(periodic.wall_nodes(0.1, 0).empty());
  EXPECT_TRUE(periodic.contains(0, 0));
  EXPECT_EQ(periodic.period_x(), 2);
  EXPECT_EQ(periodic.period_y(), 1);
  EXPECT_DOUBLE_EQ(periodic.area(), 2);
}

TEST(PeriodicVessel, CountsImagesAcrossTheSeam) {
  const Outline outline = outline_of(vessels()[1]);
  EXPECT_EQ(outline.period_x(), 3);
  EXPECT_NEAR(outline.distance(2.75, 0.2).value, std::hypot(0.35, 0.2) - 0.3, 1e-14);
  EXPECT_NEAR(outline.distance(3.05, 0.4).value, outline.distance(0.05, 0.4).value, 1e-14);
}

TEST(VesselWalls, AreTheSameAtAnyScale) {
  for (Case scene : vessels()) {
    const Outline outline = outline_of(scene);
    Vessel& v = scene.vessel;
    for (double* length : {&v.length, &v.diameter, &v.branches[0].length, &v.branches[0].diameter,
                           &v.branches[1].length, &v.branches[1].diameter}) {
      *length *= 1e-5;
    }
    for (Thrombus& t : scene.thrombi) {
      t.x *= 1e-5;
      t.radius *= 1e-5;
    }
    const Outline small(scene, 1e-5, 1);
    EXPECT_NEAR(small.area(), outline.area(), 1e-12);
    EXPECT_NEAR(small.narrowest(), outline.narrowest(), 1e-12);
    const auto nodes = outline.wall_nodes(0.04, 0.3), small_nodes = small.wall_nodes(0.04, 0.3);
    ASSERT_EQ(nodes.size(), small_nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      ASSERT_NEAR(nodes[k].x, small_nodes[k].x, 1e-12);
      ASSERT_NEAR(nodes[k].y, small_nodes[k].y, 1e-12);
    }
  }
}

}  // namespace
}  // namespace rouleau::geometry
