#include "engine/cells/rest_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace rouleau::cells {
namespace {

using std::numbers::pi;

struct Extent {
  double length, width, centre_thickness;
};

/// The shape's extent along x and y, and its thickness on the y axis.
Extent extent_of(const RestShape& shape) {
  const auto [left, right] = std::ranges::minmax(shape.x);
  const auto [low, high] = std::ranges::minmax(shape.y);
  double top = 0.0, bottom = 0.0;
  for (std::size_t i = 0; i < shape.x.size(); ++i) {
    const std::size_t j = (i + 1) % shape.x.size();
    if ((shape.x[i] > 0.0) == (shape.x[j] > 0.0)) continue;
    const double s = shape.x[i] / (shape.x[i] - shape.x[j]);
    (shape.x[i] > 0.0 ? top : bottom) = (1.0 - s) * shape.y[i] + s * shape.y[j];
  }
  return {right - left, high - low, top - bottom};
}

/// Least bending energy of a closed curve of perimeter 2 pi R0 and area alpha pi R0^2 (Euler's elastica under
/// pressure, calculated independently), lengths over R0.
struct Elastica {
  double alpha;
  Extent extent;
};

class BiconcaveShape : public testing::TestWithParam<Elastica> {
 protected:
  static void compare(int nodes, double tolerance) {
    // Bending strains this membrane by less than 1e-4.
    const Material stiff{1e4, 1.0, 2.0 * pi / nodes};
    const auto [alpha, expected] = GetParam();
    const Extent found = extent_of(rest_shape(stiff, nodes, alpha * pi));
    EXPECT_NEAR(found.length / expected.length, 1.0, tolerance);
    EXPECT_NEAR(found.width / expected.width, 1.0, tolerance);
    EXPECT_NEAR(found.centre_thickness / expected.centre_thickness, 1.0, tolerance);
  }
};

TEST_P(BiconcaveShape, IsTheElasticaWithinOnePercentWithFiftyNodes) {
  compare(50, 0.01);
}

TEST_P(BiconcaveShape, IsTheElasticaWithinAFifthOfAPercentWithTwoHundredNodes) {
  compare(200, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Validation, BiconcaveShape,
                         testing::Values(Elastica{0.9, {2.4392, 1.4083, 1.4083}},
                                         Elastica{0.8, {2.5723, 1.1195, 1.1172}},
                                         Elastica{0.6, {2.7019, 0.8121, 0.6534}},
                                         Elastica{0.5, {2.7310, 0.7206, 0.4466}},
                                         Elastica{0.481, {2.7346, 0.7055, 0.4084}}),
                         [](const auto& instance) {
                           return "Alpha" + std::to_string(std::lround(1000.0 * instance.param.alpha));
                         });

/// The study's cell: k_s = 1e-5 N/m and k_b = 2.4e-11 N at l0 = 0.4 um, a circle of 6.36 um deflated to half.
constexpr double diameter = 6.36e-6;

/// @param dimple  allowed error of the thickness in the middle
void expect_published_shape(const Material& material, double dimple) {
  const RestShape shape = rest_shape(material, 50, 0.5 * pi * diameter * diameter / 4.0);
  const Extent found = extent_of(shape);
  EXPECT_NEAR(found.length / 7.53e-6, 1.0, 0.01);
  EXPECT_NEAR(found.width / 2.38e-6, 1.0, 0.01);
  EXPECT_NEAR(found.centre_thickness / 2.18e-6, 1.0, dimple);
  EXPECT_NEAR(shape.perimeter / (pi * diameter) / 0.877, 1.0, 0.01);
}

TEST(PublishedCell, RestsAsEquationsTenAndElevenBalance) {
  expect_published_shape({1e-5, 4.8e-18, pi * diameter / 50, 0.0}, 0.01);
}

/// At rest its softest links are already below 0.8 l0, so the guard against crushing shows, by little.
TEST(PublishedCell, IsHardlyChangedByTheGuardAgainstCrushing) {
  expect_published_shape({1e-5, 4.8e-18, pi * diameter / 50}, 0.03);
}

}  // namespace
}  // namespace rouleau::cells
