#include "engine/cells/shape_class.h"

#include <set>

#include <gtest/gtest.h>

#include "engine/cells/ring.h"
#include "tests/unit/engine/cells/analytic_rings.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

std::array<double, 2> direction(double degrees) {
  return {std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)};
}

struct Example {
  const char* name;
  Nodes nodes;
  ShapeClass shape;
};

class Classes : public testing::TestWithParam<Example> {};

TEST_P(Classes, AreThoseOfTheShapeWhicheverWayItMoves) {
  for (const double degrees : {0.0, 30.0, 90.0, -120.0, 180.0}) {
    for (const double scale : {1.0, 1e-6}) {
      Nodes nodes = turned(GetParam().nodes, degrees, 7, -3);
      for (auto* coordinates : {&nodes.x, &nodes.y}) {
        for (double& value : *coordinates) value *= scale;
      }
      ASSERT_GT(area(nodes.ring()), 0);
      EXPECT_EQ(name_of(classify(nodes.ring(), direction(degrees))), name_of(GetParam().shape)) << degrees;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rings, Classes,
    testing::Values(Example{"Circle", flat_ellipse(1, 1), ShapeClass::other},
                    Example{"Ellipse", flat_ellipse(3, 1), ShapeClass::other},
                    Example{"RestingCell", evans_fung(), ShapeClass::biconcave},
                    Example{"UprightRestingCell", turned(evans_fung(), 90), ShapeClass::biconcave},
                    Example{"CoarseRestingCell", evans_fung(50), ShapeClass::biconcave},
                    Example{"Umbrella", bent_ellipse(0.4, 0), ShapeClass::parachute},
                    Example{"UmbrellaBackwards", turned(bent_ellipse(0.4, 0), 180), ShapeClass::parachute},
                    Example{"LopsidedUmbrella", bent_ellipse(0.4, 0.7), ShapeClass::slipper},
                    Example{"UmbrellaAcross", turned(bent_ellipse(0.4, 0), 90), ShapeClass::slipper},
                    Example{"Hairpin", hairpin(), ShapeClass::folded},
                    Example{"HairpinAcross", turned(hairpin(), 90), ShapeClass::folded}),
    [](const auto& example) { return std::string(example.param.name); });

TEST(Concavities, AreMeasuredFromTheConvexHull) {
  // A square of side 4 with a notch in its right side, 2 wide at the mouth and 1.5 deep.
  const Nodes notched{{0, 4, 4, 2.5, 4, 4, 0}, {0, 0, 1, 2, 3, 4, 4}};
  const auto found = concavities(notched.ring(), 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].depth, 1.5);
  EXPECT_DOUBLE_EQ(found[0].nx, 1);
  EXPECT_DOUBLE_EQ(found[0].ny, 0);
  EXPECT_LE(found[0].mouth, 4);
  EXPECT_TRUE(concavities(notched.ring(), 1.6).empty());
  EXPECT_TRUE(concavities(flat_ellipse(3, 1).ring(), 0).empty());
}

TEST(Asymmetry, IsTheAreaThatTheMirrorImageDoesNotShare) {
  // An ellipse and its mirror image at 45 degrees share 4 a b atan(b / a).
  const double a = 3, b = 1;
  for (const double degrees : {45.0, -45.0}) {
    EXPECT_NEAR(asymmetry(turned(flat_ellipse(a, b, 2000), degrees, 5, 9).ring(), {2, 0}),
                1 - 4 * std::atan(b / a) / pi, 1e-3);
  }
  EXPECT_NEAR(asymmetry(flat_ellipse(a, b).ring(), {1, 0}), 0, 1e-12);
  EXPECT_NEAR(asymmetry(flat_ellipse(a, b).ring(), {0, 1}), 0, 1e-12);
  EXPECT_NEAR(asymmetry(bent_ellipse(1, 0).ring(), {1, 0}), 0, 1e-12);
  EXPECT_GT(asymmetry(bent_ellipse(1, 0).ring(), {0, 1}), 0.2);
}

TEST(ShapeClass, NamesAreDistinct) {
  std::set<std::string_view> names;
  for (int code = 0; code <= 4; ++code)
    EXPECT_TRUE(names.insert(name_of(static_cast<ShapeClass>(code))).second);
}

}  // namespace
}  // namespace rouleau::cells
