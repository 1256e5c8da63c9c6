#include "engine/cells/rest_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/cells/bending.h"
#include "engine/cells/shape.h"
#include "engine/cells/stretch.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

constexpr double diameter = 6.36e-6;

Material material_of(int nodes, double stretch_modulus = 1e-5) {
  return {stretch_modulus, 4.8e-18, pi * diameter / nodes};
}

double circle_area() {
  return pi * diameter * diameter / 4.0;
}

/// Largest nodal force left when the best uniform pressure is taken off, over that of the pressure B / R0^3
/// at which a circle buckles.
double imbalance(const RestShape& shape, const Material& material) {
  const std::size_t n = shape.x.size();
  const Ring ring{shape.x, shape.y};
  std::vector<double> fx(n, 0.0), fy(n, 0.0);
  add_bending_forces(ring, material, fx, fy);
  add_stretch_forces(ring, material, fx, fy);
  double force_growth = 0.0, growth2 = 0.0;
  const auto growth = [&](std::size_t i) {
    const std::size_t before = ring.previous(i), after = ring.next(i);
    return std::array{(ring.y[after] - ring.y[before]) / 2.0, (ring.x[before] - ring.x[after]) / 2.0};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto [gx, gy] = growth(i);
    force_growth += fx[i] * gx + fy[i] * gy;
    growth2 += gx * gx + gy * gy;
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [gx, gy] = growth(i);
    const double pressure = force_growth / growth2;
    worst = std::max(worst, std::hypot(fx[i] - pressure * gx, fy[i] - pressure * gy));
  }
  const double radius = diameter / 2.0;
  return worst / (material.bend_modulus * material.rest_length / (radius * radius * radius));
}

TEST(RestShape, IsForceFreeAtTheExactArea) {
  for (const int nodes : {16, 50, 51, 100}) {
    for (const double fill : {0.35, 0.5, 0.8, 0.95}) {
      for (const double stretch_modulus : {1e-5, 1e-3}) {
        const Material material = material_of(nodes, stretch_modulus);
        const RestShape shape = rest_shape(material, nodes, fill * circle_area());
        ASSERT_EQ(shape.x.size(), static_cast<std::size_t>(nodes));
        EXPECT_NEAR(area({shape.x, shape.y}) / (fill * circle_area()), 1.0, 1e-12);
        EXPECT_DOUBLE_EQ(shape.area, area({shape.x, shape.y}));
        EXPECT_DOUBLE_EQ(shape.perimeter, perimeter({shape.x, shape.y}));
        EXPECT_LT(imbalance(shape, material), 1e-6) << nodes << " nodes, fill " << fill;
        EXPECT_LE(shape.iterations, 100);
      }
    }
  }
}

TEST(RestShape, IsSymmetricCentredAndLiesAlongX) {
  const int nodes = 50;
  const RestShape shape = rest_shape(material_of(nodes), nodes, 0.5 * circle_area());
  const double tolerance = 1e-9 * diameter;
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::size_t below = nodes - 1 - i, opposite = (i + nodes / 2) % nodes;
    EXPECT_NEAR(shape.x[i], shape.x[below], tolerance);
    EXPECT_NEAR(shape.y[i], -shape.y[below], tolerance);
    EXPECT_NEAR(shape.x[i], -shape.x[opposite], tolerance);
    EXPECT_NEAR(shape.y[i], -shape.y[opposite], tolerance);
  }
  const Shape measured = measure({shape.x, shape.y});
  EXPECT_NEAR(measured.x, 0.0, tolerance);
  EXPECT_NEAR(measured.y, 0.0, tolerance);
  EXPECT_NEAR(measured.angle, 0.0, 1e-9);
  EXPECT_GT(shape.x.front(), 0.4 * diameter);
  EXPECT_GT(shape.y.front(), 0.0);
  EXPECT_LT(shape.y.back(), 0.0);
}

TEST(RestShape, IsTheSameInAnyUnitsAndEveryTime) {
  const Material metres = material_of(50);
  const RestShape shape = rest_shape(metres, 50, 0.5 * circle_area());
  const RestShape again = rest_shape(metres, 50, 0.5 * circle_area());
  const Material micrometres{1e-5, 4.8e-18 * 1e12, metres.rest_length * 1e6};
  const RestShape scaled = rest_shape(micrometres, 50, 0.5 * circle_area() * 1e12);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(shape.x[i], again.x[i]);
    EXPECT_NEAR(scaled.x[i], 1e6 * shape.x[i], 1e-6);
  }
}

TEST(RestShape, HoldsLessEnergyThanItsNeighbours) {
  const Material material = material_of(50);
  const RestShape rest = rest_shape(material, 50, 0.5 * circle_area());
  const auto energy = [&](Ring ring) {
    return stretch_energy(ring, material) + bending_energy(ring, material);
  };
  const double least = energy({rest.x, rest.y});
  for (int mode = 0; mode <= 6; ++mode) {
    RestShape moved = rest;
    for (std::size_t i = 0; i < 50; ++i) {
      const double angle = 2.0 * pi * (static_cast<double>(i) + 0.5) / 50.0;
      moved.x[i] += 0.01 * diameter * std::cos(mode * angle + 0.3) * std::cos(angle);
      moved.y[i] += 0.01 * diameter * std::cos(mode * angle + 0.3) * std::sin(angle);
    }
    const double back = std::sqrt(rest.area / area({moved.x, moved.y}));
    for (double& x : moved.x) x *= back;
    for (double& y : moved.y) y *= back;
    EXPECT_GE(energy({moved.x, moved.y}), least * (1.0 - 1e-12)) << "mode " << mode;
  }
}

TEST(RestShape, InflatesBeyondTheUnstretchedArea) {
  const RestShape shape = rest_shape(material_of(50), 50, 1.2 * circle_area());
  EXPECT_NEAR(shape.area, 1.2 * circle_area(), 1e-12 * circle_area());
  const double radius = std::hypot(shape.x[0], shape.y[0]);
  for (std::size_t i = 0; i < 50; ++i)
    EXPECT_NEAR(std::hypot(shape.x[i], shape.y[i]), radius, 1e-12 * radius);
  EXPECT_EQ(shape.iterations, 0);
}

TEST(RestShape, RefusesWhatItCannotFind) {
  const Material material = material_of(50);
  EXPECT_THROW(rest_shape(material, 7, circle_area()), RestShapeError);
  EXPECT_THROW(rest_shape(material, 50, 0.0), RestShapeError);
  EXPECT_THROW(rest_shape(material, 50, std::numeric_limits<double>::quiet_NaN()), RestShapeError);
  EXPECT_THROW(rest_shape({0.0, 4.8e-18, 4e-7}, 50, circle_area()), RestShapeError);
  // So deflated, the two sides of a stiff membrane would pass through one another.
  EXPECT_THROW(rest_shape(material_of(50, 1e-3), 50, 0.2 * circle_area()), RestShapeError);
}

}  // namespace
}  // namespace rouleau::cells
