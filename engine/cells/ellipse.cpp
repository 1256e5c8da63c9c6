#include "engine/cells/ellipse.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rouleau::cells {
namespace {

/// Perimeter of the ellipse with long semi-axis 1.
double perimeter_at(double aspect) {
  return 4.0 * std::comp_ellint_2(std::sqrt(1.0 - aspect * aspect));
}

/// Short over long axis, by bisection on the area that a perimeter encloses.
double aspect_of(double perimeter, double area) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double aspect = (low + high) / 2.0;
    const double scale = perimeter / perimeter_at(aspect);
    (std::numbers::pi * aspect * scale * scale < area ? low : high) = aspect;
  }
  return (low + high) / 2.0;
}

}  // namespace

Ellipse ellipse_of(double perimeter, double area, int nodes) {
  const double aspect = aspect_of(perimeter, area);
  const double a = perimeter / perimeter_at(aspect), b = a * aspect;

  const int chords = 64 * nodes;
  std::vector<double> arc(static_cast<std::size_t>(chords) + 1, 0.0);
  const double chord_angle = 2.0 * std::numbers::pi / chords;
  for (std::size_t i = 1; i < arc.size(); ++i) {
    const double middle = (static_cast<double>(i) - 0.5) * chord_angle;
    arc[i] = arc[i - 1] + chord_angle * std::hypot(a * std::sin(middle), b * std::cos(middle));
  }

  Ellipse ellipse;
  std::size_t chord = 0;
  for (int i = 0; i < nodes; ++i) {
    const double target = arc.back() * (i + 0.5) / nodes;
    while (arc[chord + 1] < target) ++chord;
    const double fraction = (target - arc[chord]) / (arc[chord + 1] - arc[chord]);
    const double angle = (static_cast<double>(chord) + fraction) * chord_angle;
    ellipse.x.push_back(a * std::cos(angle));
    ellipse.y.push_back(b * std::sin(angle));
  }
  return ellipse;
}

}  // namespace rouleau::cells
