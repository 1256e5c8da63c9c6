#include "engine/operators/scraper_flow.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "engine/geometry/outline.h"

namespace rouleau::operators {
namespace {

/// A box of 2 x 1 whose four walls move at speeds of their own.
class Corners : public testing::Test {
 protected:
  static std::vector<geometry::WallChain> walls(const WallVelocity& speeds) {
    Case scene;
    scene.vessel.shape = Shape::box;
    scene.vessel.ends = Ends::closed;
    scene.vessel.length = 2;
    scene.vessel.diameter = 1;
    scene.vessel.wall_velocity = speeds;
    return geometry::Outline(scene, 1, 1).walls();
  }

  static double derivative(const std::function<double(double)>& f, double at) {
    constexpr double h = 1e-4;
    return (f(at + h) - f(at - h)) / (2 * h);
  }
  static double second_derivative(const std::function<double(double)>& f, double at) {
    constexpr double h = 1e-3;
    return (f(at + h) - 2 * f(at) + f(at - h)) / (h * h);
  }

  const ScraperFlow flow_{walls({.lower = 0.3, .upper = 1, .left = -0.7, .right = 0.2})};
};

TEST_F(Corners, AWallAtRestHasNone) {
  EXPECT_FALSE(ScraperFlow(walls({})).any());
  EXPECT_EQ(ScraperFlow(walls({})).at(0.3, 0.2).u, 0);
  EXPECT_TRUE(flow_.any());
}

// What the other corner's flow adds there is the same on both walls.
TEST_F(Corners, TheVelocityJumpsInACornerAsTheWallsDo) {
  const ScraperFlow lid(walls({.upper = 1}));
  for (const double r : {1e-6, 1e-3}) {
    EXPECT_NEAR(lid.at(r, 1).u - lid.at(0, 1 - r).u, 1, 2 * r);
    EXPECT_NEAR(lid.at(2 - r, 1).u - lid.at(2, 1 - r).u, 1, 2 * r);
    EXPECT_NEAR(lid.at(r, 1).v - lid.at(0, 1 - r).v, 0, 2 * r);
    EXPECT_NEAR(lid.at(0, 1).u, lid.at(0, 1 - r).u, 2 * r);
  }
}

TEST_F(Corners, TheFlowIsFreeOfDivergence) {
  for (const auto& [x, y] : {std::pair(0.2, 0.3), std::pair(1.7, 0.9), std::pair(0.05, 0.96)}) {
    const double ux = derivative([&](double at) { return flow_.at(at, y).u; }, x);
    const double vy = derivative([&](double at) { return flow_.at(x, at).v; }, y);
    EXPECT_NEAR(ux + vy, 0, 1e-4);
    EXPECT_GT(std::abs(ux), 1e-2);
  }
}

TEST_F(Corners, PressureBalancesViscosity) {
  for (const auto& [x, y] : {std::pair(0.2, 0.3), std::pair(1.7, 0.8), std::pair(0.1, 0.9)}) {
    const double px = derivative([&](double at) { return flow_.at(at, y).p; }, x);
    const double py = derivative([&](double at) { return flow_.at(x, at).p; }, y);
    const double lu = second_derivative([&](double at) { return flow_.at(at, y).u; }, x) +
                      second_derivative([&](double at) { return flow_.at(x, at).u; }, y);
    const double lv = second_derivative([&](double at) { return flow_.at(at, y).v; }, x) +
                      second_derivative([&](double at) { return flow_.at(x, at).v; }, y);
    EXPECT_NEAR(lu, px, 2e-3 * std::hypot(px, py));
    EXPECT_NEAR(lv, py, 2e-3 * std::hypot(px, py));
  }
}

}  // namespace
}  // namespace rouleau::operators
