#include "engine/cells/shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

Nodes ellipse(double a, double b, double degrees, double cx, double cy, int n = 2000) {
  const double tilt = degrees * pi / 180.0;
  Nodes nodes;
  for (int i = 0; i < n; ++i) {
    const double x = a * std::cos(2.0 * pi * i / n), y = b * std::sin(2.0 * pi * i / n);
    nodes.x.push_back(cx + x * std::cos(tilt) - y * std::sin(tilt));
    nodes.y.push_back(cy + x * std::sin(tilt) + y * std::cos(tilt));
  }
  return nodes;
}

TEST(Shape, MeasuresAnEllipse) {
  const double a = 4.0, b = 1.5;
  const Nodes nodes = ellipse(a, b, 30.0, 7.0, -2.0);
  const Shape shape = measure(nodes.ring());
  EXPECT_NEAR(shape.area, pi * a * b, 1e-4);
  EXPECT_NEAR(shape.perimeter, 4.0 * a * std::comp_ellint_2(std::sqrt(1.0 - b * b / (a * a))), 1e-4);
  EXPECT_NEAR(shape.x, 7.0, 1e-10);
  EXPECT_NEAR(shape.y, -2.0, 1e-10);
  EXPECT_NEAR(shape.angle, 30.0, 1e-8);
  EXPECT_NEAR(shape.inertia_area, pi * a * b / 4.0 * std::hypot(a * a, b * b), 1e-3);
  EXPECT_NEAR(shape.inertia_nodes, std::hypot(a * a, b * b) / 2.0, 1e-8);  // nodes at equal parameter steps
}

TEST(Shape, MeasuresASquareAndATriangle) {
  const Nodes square{{1.0, 3.0, 3.0, 1.0}, {5.0, 5.0, 7.0, 7.0}};
  const Shape shape = measure(square.ring());
  EXPECT_DOUBLE_EQ(shape.area, 4.0);
  EXPECT_DOUBLE_EQ(shape.perimeter, 8.0);
  EXPECT_DOUBLE_EQ(shape.x, 2.0);
  EXPECT_DOUBLE_EQ(shape.y, 6.0);
  EXPECT_NEAR(shape.inertia_nodes, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(shape.inertia_area, 16.0 / 12.0 * std::sqrt(2.0), 1e-12);

  const Nodes triangle{{0.0, 3.0, 0.0}, {0.0, 0.0, 6.0}};
  EXPECT_DOUBLE_EQ(area(triangle.ring()), 9.0);
  EXPECT_DOUBLE_EQ(measure(triangle.ring()).x, 1.0);
  EXPECT_DOUBLE_EQ(measure(triangle.ring()).y, 2.0);
  // b h^3 / 36, h b^3 / 36, and -b^2 h^2 / 72 for the product.
  EXPECT_NEAR(measure(triangle.ring()).inertia_area, std::sqrt(18.0 * 18.0 + 4.5 * 4.5 + 2.0 * 4.5 * 4.5),
              1e-12);
}

TEST(Shape, AngleIsThatOfTheLongAxis) {
  for (const double angle : {-89.0, -45.0, 0.0, 10.0, 90.0}) {
    EXPECT_NEAR(measure(ellipse(3.0, 1.0, angle, 0.0, 0.0).ring()).angle, angle, 1e-8);
  }
  EXPECT_NEAR(measure(ellipse(3.0, 1.0, 135.0, 0.0, 0.0).ring()).angle, -45.0, 1e-8);
  const Nodes upright{{-1.0, 1.0, 1.0, -1.0}, {-4.0, -4.0, 4.0, 4.0}};
  EXPECT_EQ(measure(upright.ring()).angle, 90.0);
  EXPECT_GT(measure(ellipse(3.0, 1.0, 90.0 + 1e-9, 0.0, 0.0).ring()).angle, 89.0);
}

TEST(Shape, DeformationFactorGrowsWithElongationAtConstantArea) {
  const Shape start = measure(ellipse(2.0, 2.0, 0.0, 0.0, 0.0).ring());
  const Shape drawn = measure(ellipse(4.0, 1.0, 70.0, 40.0, 5.0).ring());
  const double expected = std::hypot(16.0, 1.0) / std::hypot(4.0, 4.0);
  EXPECT_NEAR(drawn.inertia_nodes / start.inertia_nodes, expected, 1e-8);
  EXPECT_NEAR(drawn.inertia_area / start.inertia_area, expected, 1e-8);
}

TEST(Shape, CentroidVelocityIsTheDerivativeOfTheCentroid) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Nodes nodes = random_ring(seed);
    const std::vector<double> u = random_vector(seed + 1000, nodes.x.size());
    const std::vector<double> v = random_vector(seed + 2000, nodes.x.size());
    const double step = 1e-6;
    const auto at = [&](double time) {
      Nodes moved = nodes;
      for (std::size_t i = 0; i < u.size(); ++i) {
        moved.x[i] += time * u[i];
        moved.y[i] += time * v[i];
      }
      return measure(moved.ring());
    };
    const Shape before = at(-step), after = at(step);
    const auto velocity = centroid_velocity(nodes.ring(), u, v);
    EXPECT_NEAR(velocity[0], (after.x - before.x) / (2.0 * step), 1e-6) << "seed " << seed;
    EXPECT_NEAR(velocity[1], (after.y - before.y) / (2.0 * step), 1e-6) << "seed " << seed;
  }
}

TEST(Shape, CentroidVelocityOfARigidMotion) {
  const Nodes nodes = random_ring(3);
  const Shape shape = measure(nodes.ring());
  std::vector<double> u, v;
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    u.push_back(2.0 - 5.0 * (nodes.y[i] - shape.y));
    v.push_back(-1.0 + 5.0 * (nodes.x[i] - shape.x));
  }
  const auto velocity = centroid_velocity(nodes.ring(), u, v);
  EXPECT_NEAR(velocity[0], 2.0, 1e-10);
  EXPECT_NEAR(velocity[1], -1.0, 1e-10);
}

}  // namespace
}  // namespace rouleau::cells
