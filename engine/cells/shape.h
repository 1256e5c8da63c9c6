#pragma once

#include <array>
#include <span>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// What is observed of a cell. With I1, I2 the principal moments of inertia about the centroid,
/// tau (eq. 23) is `inertia_nodes` over its value at the start, and tau_area the same of `inertia_area`.
struct Shape {
  double area;
  double perimeter;
  double x, y;           ///< centroid of the enclosed area
  double angle;          ///< of the long axis of the enclosed area to x, degrees in (-90, 90]; 0 for a disc
  double inertia_nodes;  ///< sqrt(I1^2 + I2^2) of the nodes, of mass 1/n each: length^2
  double inertia_area;   ///< sqrt(I1^2 + I2^2) of the enclosed area at density 1, not divided by it: length^4
};

Shape measure(Ring ring);

/// Velocity of the centroid of the enclosed area when the nodes move with (u, v): the exact time derivative.
std::array<double, 2> centroid_velocity(Ring ring, std::span<const double> u, std::span<const double> v);

/// Whether the point is enclosed, by the even-odd rule (a ring that crosses itself included).
bool contains(Ring ring, double px, double py);

/// The point of a ring nearest to another point.
struct Nearest {
  int link;         ///< the first of several at the same distance
  double s;         ///< position along the link, 0 to 1
  double distance;  ///< never negative, inside or outside
  double x, y;
  double nx, ny;  ///< outward unit normal of the link
};

Nearest nearest(Ring ring, double px, double py);

}  // namespace rouleau::cells
