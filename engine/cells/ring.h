#pragma once

#include <cstddef>
#include <span>

namespace rouleau::cells {

/// A view of a membrane: the nodes of a closed polygon, counter-clockwise; link i joins node i to node
/// i + 1, the last one to node 0. `x` and `y` have the same size, at least three. Any consistent units.
struct Ring {
  std::span<const double> x, y;

  std::size_t size() const { return x.size(); }
  std::size_t next(std::size_t node) const { return node + 1 == size() ? 0 : node + 1; }
  std::size_t previous(std::size_t node) const { return node == 0 ? size() - 1 : node - 1; }
};

/// Enclosed area, positive for a counter-clockwise ring.
double area(Ring ring);

double perimeter(Ring ring);

/// Mean thickness: twice the area over the perimeter, which is that of a long band.
double thickness(Ring ring);

/// Of a ring's links: length over unstretched length, less 1.
struct Strain {
  double mean, greatest;
};

Strain strain(Ring ring, double rest_length);

}  // namespace rouleau::cells
