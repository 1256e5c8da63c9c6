#pragma once

#include <vector>

namespace rouleau::cells {

/// Nodes at equal arc lengths on the ellipse of the given perimeter and area, counter-clockwise, long axis
/// along x, half a link after the positive x axis first. `area` must be below that of the circle.
struct Ellipse {
  std::vector<double> x, y;
};

Ellipse ellipse_of(double perimeter, double area, int nodes);

}  // namespace rouleau::cells
