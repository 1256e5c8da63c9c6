#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {

/// Nodes (x(t), y(t)) at n equal steps of t over a full turn.
template <class Curve>
Nodes ring_of(int n, Curve curve) {
  Nodes nodes;
  for (int i = 0; i < n; ++i) {
    const std::array<double, 2> at = curve(2 * std::numbers::pi * i / n);
    nodes.x.push_back(at[0]);
    nodes.y.push_back(at[1]);
  }
  return nodes;
}

/// An ellipse with its long axis along x.
inline Nodes flat_ellipse(double a, double b, int n = 200) {
  return ring_of(n, [&](double t) { return std::array{a * std::cos(t), b * std::sin(t)}; });
}

/// The cross-section of a resting cell by Evans and Fung, Microvasc. Res. 4, 335 (1972), in um.
inline Nodes evans_fung(int n = 200) {
  return ring_of(n, [](double t) {
    const double c = std::cos(t), c2 = c * c;
    return std::array{3.91 * c, 0.5 * std::sin(t) * (0.81 + 7.83 * c2 - 4.39 * c2 * c2)};
  });
}

/// An upright ellipse, 1 by 4, bent so that its ends trail: the middle line is x = -bend (y - off)^2.
inline Nodes bent_ellipse(double bend, double off, int n = 200) {
  return ring_of(n, [&](double t) {
    const double y = 2 * std::sin(t);
    return std::array{0.5 * std::cos(t) - bend * (y - off) * (y - off), y};
  });
}

/// A band of thickness 0.6 around half a circle of radius 1, with straight arms of length 3 towards -x.
inline Nodes hairpin() {
  const double pi = std::numbers::pi, turn = 6 + pi;
  const auto middle = [&](double s) -> std::array<double, 4> {  // place and normal to the right
    if (s < 3) return {s - 3, -1, 0, -1};
    if (s > 3 + pi) return {3 + pi - s, 1, 0, 1};
    const double angle = s - 3 - pi / 2;
    return {std::cos(angle), std::sin(angle), std::cos(angle), std::sin(angle)};
  };
  Nodes nodes;
  for (const double side : {0.3, -0.3}) {
    for (int i = 0; i <= 60; ++i) {
      const auto [x, y, nx, ny] = middle(side > 0 ? turn * i / 60 : turn * (60 - i) / 60);
      nodes.x.push_back(x + side * nx);
      nodes.y.push_back(y + side * ny);
    }
  }
  return nodes;
}

inline Nodes turned(const Nodes& nodes, double degrees, double dx = 0, double dy = 0) {
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  Nodes result;
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    result.x.push_back(c * nodes.x[i] - s * nodes.y[i] + dx);
    result.y.push_back(s * nodes.x[i] + c * nodes.y[i] + dy);
  }
  return result;
}

}  // namespace rouleau::cells
