#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {
namespace {

/// Points spread over the box of a ring and a margin around it.
Nodes points_around(const Nodes& nodes, std::uint32_t seed, std::size_t count) {
  const auto [left, right] = std::ranges::minmax(nodes.x);
  const auto [low, high] = std::ranges::minmax(nodes.y);
  Nodes points{random_vector(seed, count), random_vector(seed + 1, count)};
  for (double& x : points.x) x = (left + right) / 2.0 + 0.7 * (right - left) * x;
  for (double& y : points.y) y = (low + high) / 2.0 + 0.7 * (high - low) * y;
  return points;
}

int winding_number(Ring ring, double px, double py) {
  double turned = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    const double ax = ring.x[i] - px, ay = ring.y[i] - py, bx = ring.x[j] - px, by = ring.y[j] - py;
    turned += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return static_cast<int>(std::lround(turned / (2.0 * std::numbers::pi)));
}

TEST(Contains, AgreesWithTheWindingNumber) {
  int inside = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Nodes nodes = random_ring(seed), points = points_around(nodes, 3000 + seed, 50);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const bool enclosed = contains(nodes.ring(), points.x[i], points.y[i]);
      EXPECT_EQ(enclosed, winding_number(nodes.ring(), points.x[i], points.y[i]) != 0);
      inside += enclosed;
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_LT(inside, 4000);
}

TEST(Contains, CountsALevelNodeOnce) {
  const Nodes diamond{{1.0, 0.0, -1.0, 0.0}, {0.0, 1.0, 0.0, -1.0}};
  EXPECT_TRUE(contains(diamond.ring(), 0.0, 0.0));
  EXPECT_FALSE(contains(diamond.ring(), -2.0, 0.0));
  EXPECT_FALSE(contains(diamond.ring(), -2.0, 1.0));
}

TEST(Nearest, AgreesWithSamplesOfTheRing) {
  constexpr int samples = 400;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Nodes nodes = random_ring(seed), points = points_around(nodes, 5000 + seed, 20);
    const Ring ring = nodes.ring();
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      const double px = points.x[p], py = points.y[p];
      const Nearest found = nearest(ring, px, py);
      double least = std::numeric_limits<double>::infinity(), spacing = 0.0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = ring.next(i);
        const double dx = ring.x[j] - ring.x[i], dy = ring.y[j] - ring.y[i];
        spacing = std::max(spacing, std::hypot(dx, dy) / samples);
        for (int k = 0; k <= samples; ++k) {
          const double s = static_cast<double>(k) / samples;
          least = std::min(least, std::hypot(ring.x[i] + s * dx - px, ring.y[i] + s * dy - py));
        }
      }
      EXPECT_LE(found.distance, least + 1e-12);
      EXPECT_GE(found.distance, least - spacing);

      const auto i = static_cast<std::size_t>(found.link), j = ring.next(i);
      EXPECT_NEAR(found.x, (1.0 - found.s) * ring.x[i] + found.s * ring.x[j], 1e-12);
      EXPECT_NEAR(found.y, (1.0 - found.s) * ring.y[i] + found.s * ring.y[j], 1e-12);
      EXPECT_NEAR(std::hypot(px - found.x, py - found.y), found.distance, 1e-12);
      EXPECT_NEAR(std::hypot(found.nx, found.ny), 1.0, 1e-12);
      if (found.s > 0.0 && found.s < 1.0) {
        const double side = (px - found.x) * found.nx + (py - found.y) * found.ny;
        EXPECT_EQ(side < 0.0, contains(ring, px, py));
        EXPECT_NEAR(std::fabs(side), found.distance, 1e-12);
      }
    }
  }
}

TEST(Nearest, PassesOverALinkWithoutLength) {
  const Nodes square{{0.0, 0.0, 1.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0, 1.0}};
  const Nearest found = nearest(square.ring(), -0.5, -0.5);
  EXPECT_EQ(found.link, 1);
  EXPECT_EQ(found.ny, -1.0);
  EXPECT_NEAR(found.distance, std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace rouleau::cells
