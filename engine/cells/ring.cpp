#include "engine/cells/ring.h"

#include <algorithm>
#include <cmath>

namespace rouleau::cells {

double area(Ring ring) {
  // Seen from node 0, so that a small cell far from the origin loses no digits.
  const double x0 = ring.x[0], y0 = ring.y[0];
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += (ring.x[i] - x0) * (ring.y[i + 1] - y0) - (ring.x[i + 1] - x0) * (ring.y[i] - y0);
  }
  return twice / 2.0;
}

double perimeter(Ring ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    sum += std::hypot(ring.x[j] - ring.x[i], ring.y[j] - ring.y[i]);
  }
  return sum;
}

double thickness(Ring ring) {
  return 2 * area(ring) / perimeter(ring);
}

Strain strain(Ring ring, double rest_length) {
  double sum = 0, longest = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    const double length = std::hypot(ring.x[j] - ring.x[i], ring.y[j] - ring.y[i]);
    sum += length;
    longest = std::max(longest, length);
  }
  return {sum / (rest_length * static_cast<double>(ring.size())) - 1, longest / rest_length - 1};
}

}  // namespace rouleau::cells
