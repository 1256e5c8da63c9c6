#include "engine/observe/cell_free_layer.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/observe/cells_of_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

constexpr double pi = std::numbers::pi;

/// Around a rectangle, counter-clockwise from its lower left corner; a corner is a node where the nodes can
/// be shared out evenly among the sides.
auto rectangle(double x0, double y0, double x1, double y1) {
  return [=](double t) {
    const double side = 4 * t - std::floor(4 * t);
    if (t < 0.25) return std::array{x0 + side * (x1 - x0), y0};
    if (t < 0.5) return std::array{x1, y0 + side * (y1 - y0)};
    if (t < 0.75) return std::array{x1 - side * (x1 - x0), y1};
    return std::array{x0, y1 - side * (y1 - y0)};
  };
}

Case fine_vessel(int cells = 1) {
  Case scene = coarse_vessel_with_cells(cells);
  scene.numerics.spacing = 0.5e-6;
  for (RedCell& cell : scene.cells) {
    cell.shape = CellShape::circle;
    cell.fill = 1;
  }
  return scene;
}

TEST(CellFreeLayer, OfABlockIsItsDistanceFromEitherWall) {
  effects::State state = effects::prepared_state(fine_vessel());
  // Lengths in diameters. The corners' last nodes lie within the sides.
  put_nodes(state, 0, rectangle(0.6, 0.25, 1.2, 0.6));
  const auto [lower, upper] = FreeLayers(state).measure(state);
  EXPECT_NEAR(lower.least, 0.25, 1e-12);
  EXPECT_NEAR(upper.least, 0.4, 1e-12);
  EXPECT_NEAR(lower.mean, 0.25, 0.01);
  EXPECT_NEAR(upper.mean, 0.4, 0.01);
}

TEST(CellFreeLayer, OfADiscIsTheMeanAlongItsWidth) {
  effects::State state = effects::prepared_state(fine_vessel());
  const double radius = 0.3;
  put_nodes(state, 0, [&](double t) {
    return std::array{1 + radius * std::cos(2 * pi * t), 0.45 + radius * std::sin(2 * pi * t)};
  });
  const auto [lower, upper] = FreeLayers(state).measure(state);
  EXPECT_NEAR(lower.mean, 0.45 - pi / 4 * radius, 0.01);
  EXPECT_NEAR(upper.mean, 0.55 - pi / 4 * radius, 0.01);
  EXPECT_NEAR(lower.least, 0.15, 0.002);
}

TEST(CellFreeLayer, IsTakenFromTheTrueWallOfAThrombus) {
  Case scene = fine_vessel();
  scene.thrombi.push_back({Wall::lower, 10e-6, 3e-6});
  scene.cells[0].x = 3e-6;
  effects::State state = effects::prepared_state(scene);
  // A cap over the thrombus: 0.1 away from it from 45 to 135 degrees, flat on top, with upright ends.
  const double edge = 0.4 * std::cos(pi / 4);
  put_nodes(state, 0, [&](double t) {
    if (t < 0.5) return std::array{1 + edge * (1 - 4 * t), 0.6};
    const double angle = 3 * pi / 4 - pi * (t - 0.5);
    return std::array{1 + 0.4 * std::cos(angle), 0.4 * std::sin(angle)};
  });
  const FreeLayer lower = FreeLayers(state).measure(state)[0];
  EXPECT_NEAR(lower.mean, 0.1, 0.003);
  EXPECT_NEAR(lower.least, 0.1, 0.003);
}

TEST(CellFreeLayer, LooksAcrossTheSeamOfAPeriodicVessel) {
  Case scene = fine_vessel();
  scene.vessel.ends = Ends::periodic;
  effects::State middle = effects::prepared_state(scene);
  put_nodes(middle, 0, rectangle(0.7, 0.25, 1.3, 0.6));
  effects::State across = middle;
  put_nodes(across, 0, rectangle(1.7, 0.25, 2.3, 0.6));
  const FreeLayers layers(middle);
  for (const std::size_t wall : {0u, 1u}) {
    EXPECT_NEAR(layers.measure(across)[wall].mean, layers.measure(middle)[wall].mean, 1e-12);
  }
}

TEST(CellFreeLayer, DoesNotLookThroughTheWallBetweenTwoBranches) {
  Case scene = fine_vessel();
  scene.vessel.shape = Shape::bifurcation;
  scene.vessel.length = 20e-6;
  scene.vessel.branches = {{{40e-6, 6e-6}, {40e-6, 6e-6}}};
  effects::State state = effects::prepared_state(scene);
  // In the lower branch: the lower outer wall is at 30 degrees below the axis.
  const double c = std::cos(pi / 6), s = std::sin(pi / 6);
  put_nodes(state, 0, [&](double t) {
    const auto [along, across] = rectangle(2, 0.2, 2.6, 0.4)(t);
    return std::array{2 + along * c + across * s, -along * s + across * c};
  });
  const auto [lower, upper] = FreeLayers(state).measure(state);
  EXPECT_NEAR(lower.least, 0.2, 1e-9);
  EXPECT_NEAR(lower.mean, 0.2, 0.01);
  EXPECT_TRUE(std::isnan(upper.mean));
}

TEST(CellFreeLayer, IsNoneOnceTheCellsHaveLeft) {
  effects::State state = effects::prepared_state(fine_vessel());
  state.cells[0].departure.emplace();
  for (const FreeLayer& layer : FreeLayers(state).measure(state)) EXPECT_TRUE(std::isnan(layer.mean));
}

}  // namespace
}  // namespace rouleau::observe
