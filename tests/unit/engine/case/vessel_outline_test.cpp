#include "engine/case/vessel_outline.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/geometry/outline.h"

namespace rouleau::testing {
namespace {

using Point = std::array<double, 2>;

Vessel bifurcation(Branch lower, Branch upper, double half_angle) {
  return {.length = 80,
          .diameter = 20,
          .shape = Shape::bifurcation,
          .branches = {lower, upper},
          .half_angle = half_angle};
}

double distance_to_line(const Point& point, const VesselSide& side) {
  const double x = side.to[0] - side.from[0], y = side.to[1] - side.from[1];
  return (x * (point[1] - side.from[1]) - y * (point[0] - side.from[0])) / std::hypot(x, y);
}

TEST(VesselOutline, OfAStraightVesselIsItsRectangle) {
  const VesselOutline outline = outline_of({.length = 8, .diameter = 3});
  EXPECT_EQ(outline.area(), 24);
  EXPECT_EQ(outline.sides.size(), 4U);
  EXPECT_EQ(outline.sides[outline.lower.at(0)].name, "lower wall");
  EXPECT_EQ(outline.sides[outline.upper.at(0)].name, "upper wall");
  EXPECT_TRUE(outline.contains({4, 1}));
  EXPECT_FALSE(outline.contains({9, 1}));
  EXPECT_FALSE(outline.contains({4, -1}));
}

TEST(VesselOutline, OfABifurcationHasBranchesOfTheirDiameters) {
  for (const double half_angle : {10.0, 30.0, 45.0, 60.0}) {
    const VesselOutline outline = outline_of(bifurcation({40, 12}, {50, 9}, half_angle));
    for (const auto& [outer, inner, diameter, length] :
         {std::tuple{1U, 3U, 12.0, 40.0}, std::tuple{6U, 4U, 9.0, 50.0}}) {
      const VesselSide& wall = outline.sides[outer];
      const double x = wall.to[0] - wall.from[0], y = wall.to[1] - wall.from[1];
      EXPECT_NEAR(std::hypot(x, y), length, 1e-12);
      EXPECT_NEAR(std::abs(y / x), std::tan(half_angle * std::numbers::pi / 180), 1e-12);
      // The inner wall runs at the branch's diameter from the outer one, the apex included.
      EXPECT_NEAR(distance_to_line(outline.sides[inner].from, wall), diameter, 1e-12);
      EXPECT_NEAR(distance_to_line(outline.sides[inner].to, wall), diameter, 1e-12);
    }
    for (const std::size_t outlet : {2U, 5U}) {
      const VesselSide& plane = outline.sides[outlet];
      EXPECT_NEAR(std::hypot(plane.to[0] - plane.from[0], plane.to[1] - plane.from[1]), outlet == 2 ? 12 : 9,
                  1e-12);
    }
  }
}

TEST(VesselOutline, OfAnEvenBifurcationIsSymmetric) {
  const Vessel vessel = bifurcation({40, 10}, {40, 10}, 30);
  const Point apex = apex_of(vessel);
  EXPECT_DOUBLE_EQ(apex[1], 10);
  EXPECT_NEAR(apex[0], 80 + 20 - 20 * std::cos(std::numbers::pi / 6), 1e-12);
  const VesselOutline outline = outline_of(vessel);
  for (const Point& point : {Point{10, 4}, Point{84, 3}, Point{100, -8}, Point{100, 9}, Point{70, -1}}) {
    EXPECT_EQ(outline.contains(point), outline.contains({point[0], 20 - point[1]})) << point[0];
  }
  EXPECT_TRUE(outline.contains({100, -5}));
  EXPECT_FALSE(outline.contains({100, 10}));
  EXPECT_TRUE(outline.contains({82, 10}));
  EXPECT_FALSE(outline.contains({83, 10}));
  EXPECT_FALSE(outline.contains({70, -1}));
}

TEST(VesselOutline, IsTheVesselThatIsComputed) {
  for (const double half_angle : {12.0, 30.0, 55.0}) {
    for (const double upper : {6.0, 12.0}) {
      Case scene;
      scene.vessel = bifurcation({60, 12}, {70, upper}, half_angle);
      const geometry::Outline computed(scene, 1, 1);
      const VesselOutline outline = outline_of(scene.vessel);
      EXPECT_NEAR(outline.area(), computed.area(), 1e-9 * computed.area());
      for (const VesselSide& side : outline.sides) {
        EXPECT_NEAR(computed.distance(side.from[0], side.from[1]).value, 0, 1e-9) << side.name;
        const bool open = side.name.ends_with("let");
        const double middle =
            computed.distance((side.from[0] + side.to[0]) / 2, (side.from[1] + side.to[1]) / 2).value;
        EXPECT_EQ(std::abs(middle) > 1e-9, open) << side.name;
      }
    }
  }
}

TEST(VesselOutline, NamesWhatIsOpen) {
  const auto names = [](Shape shape, Ends ends) {
    const VesselOutline outline = outline_of({.length = 8, .diameter = 3, .shape = shape, .ends = ends});
    return outline.sides[1].name + ", " + outline.sides[3].name;
  };
  EXPECT_EQ(names(Shape::straight, Ends::open), "outlet, inlet");
  EXPECT_EQ(names(Shape::straight, Ends::periodic), "right end, left end");
  EXPECT_EQ(names(Shape::box, Ends::closed), "right wall, left wall");
}

}  // namespace
}  // namespace rouleau::testing
