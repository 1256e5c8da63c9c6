#include "engine/cells/shape.h"

#include <cmath>
#include <numbers>

namespace rouleau::cells {
namespace {

/// Second moments of a distribution about its centroid.
struct Moments {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};

/// sqrt(I1^2 + I2^2): the principal moments are the eigenvalues of this tensor, whose Frobenius norm it is.
double inertia(const Moments& m) {
  return std::sqrt(m.xx * m.xx + m.yy * m.yy + 2.0 * m.xy * m.xy);
}

double long_axis_angle(const Moments& m) {
  const double degrees = std::atan2(2.0 * m.xy, m.xx - m.yy) * 90.0 / std::numbers::pi;
  // An upright cell must not flip between -90 and 90 by rounding.
  return degrees > -90.0 + 1e-6 ? degrees : degrees + 180.0;
}

Moments node_moments(Ring ring) {
  const double n = static_cast<double>(ring.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    mean_x += ring.x[i] / n;
    mean_y += ring.y[i] / n;
  }
  Moments m;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double dx = ring.x[i] - mean_x, dy = ring.y[i] - mean_y;
    m.xx += dx * dx / n;
    m.yy += dy * dy / n;
    m.xy += dx * dy / n;
  }
  return m;
}

struct AreaMoments {
  double area = 0.0, x = 0.0, y = 0.0;
  Moments central;
};

/// Integrals over the triangles that node 0 spans with each link; each is exact for a polygon.
AreaMoments area_moments(Ring ring) {
  const double x0 = ring.x[0], y0 = ring.y[0];
  AreaMoments sum;
  Moments& m = sum.central;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const double ax = ring.x[i] - x0, ay = ring.y[i] - y0;
    const double bx = ring.x[i + 1] - x0, by = ring.y[i + 1] - y0;
    const double triangle = (ax * by - bx * ay) / 2.0;
    sum.area += triangle;
    sum.x += triangle * (ax + bx) / 3.0;
    sum.y += triangle * (ay + by) / 3.0;
    m.xx += triangle * (ax * ax + ax * bx + bx * bx) / 6.0;
    m.yy += triangle * (ay * ay + ay * by + by * by) / 6.0;
    m.xy += triangle * (2.0 * ax * ay + ax * by + bx * ay + 2.0 * bx * by) / 12.0;
  }
  sum.x /= sum.area;
  sum.y /= sum.area;
  m.xx -= sum.area * sum.x * sum.x;
  m.yy -= sum.area * sum.y * sum.y;
  m.xy -= sum.area * sum.x * sum.y;
  sum.x += x0;
  sum.y += y0;
  return sum;
}

}  // namespace

Shape measure(Ring ring) {
  const AreaMoments enclosed = area_moments(ring);
  return {enclosed.area,
          perimeter(ring),
          enclosed.x,
          enclosed.y,
          long_axis_angle(enclosed.central),
          inertia(node_moments(ring)),
          inertia(enclosed.central)};
}

std::array<double, 2> centroid_velocity(Ring ring, std::span<const double> u, std::span<const double> v) {
  // d/dt of (integral of r dA) / A: the rate of each triangle's area times its centroid, and the reverse,
  // with node 0 as a fixed origin that the ring moves away from.
  const double x0 = ring.x[0], y0 = ring.y[0];
  double twice_area = 0.0, area_rate = 0.0;
  double moment_x = 0.0, moment_y = 0.0, rate_x = 0.0, rate_y = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    const double ax = ring.x[i] - x0, ay = ring.y[i] - y0, bx = ring.x[j] - x0, by = ring.y[j] - y0;
    const double cross = ax * by - bx * ay;
    const double cross_rate = u[i] * by + ax * v[j] - u[j] * ay - bx * v[i];
    twice_area += cross;
    area_rate += cross_rate;
    moment_x += cross * (ax + bx);
    moment_y += cross * (ay + by);
    rate_x += cross_rate * (ax + bx) + cross * (u[i] + u[j]);
    rate_y += cross_rate * (ay + by) + cross * (v[i] + v[j]);
  }
  return {(rate_x - moment_x / twice_area * area_rate) / (3.0 * twice_area),
          (rate_y - moment_y / twice_area * area_rate) / (3.0 * twice_area)};
}

}  // namespace rouleau::cells
