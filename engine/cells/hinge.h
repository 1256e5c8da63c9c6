#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"

namespace rouleau::cells {

/// A node as the hinge between its two links.
struct Hinge {
  std::array<std::size_t, 3> node;  ///< previous, the node itself, next
  double angle;                     ///< turning angle in (-pi, pi], positive where the ring is convex
  std::array<double, 6> gradient;   ///< of the angle by x0, y0, x1, y1, x2, y2
};

inline Hinge hinge_at(Ring ring, std::size_t node) {
  const std::size_t before = ring.previous(node), after = ring.next(node);
  const double ax = ring.x[node] - ring.x[before], ay = ring.y[node] - ring.y[before];
  const double bx = ring.x[after] - ring.x[node], by = ring.y[after] - ring.y[node];
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by;
  const double px = -ay / a2,
               py = ax / a2;  // of the first link's direction by its own vector, then the second's
  const double qx = -by / b2, qy = bx / b2;
  return {{before, node, after},
          std::atan2(ax * by - ay * bx, ax * bx + ay * by),
          {px, py, -(px + qx), -(py + qy), qx, qy}};
}

/// Eq. 11 in conservative form: its two forces, scaled by l0 / l, are the gradient of this energy.
struct HingeLaw {
  double energy;
  double moment;  ///< dE/dtheta
  double slope;   ///< d2E/dtheta2
};

/// E = -(4 B / l0) ln cos(theta / 2). From |theta| = 2.8 on (the links folded back on one another) the moment
/// goes on linearly: finite, however far a bad step folds the ring.
/// `rest_length`, the hinge's l0, is the mean of its links'.
inline HingeLaw hinge_law(double angle, const Material& material, double rest_length) {
  constexpr double fold = 2.8;
  const double unit = material.bend_modulus / rest_length;
  const double within = std::fmin(std::fabs(angle), fold), beyond = std::fabs(angle) - within;
  const double tangent = std::tan(within / 2.0);
  const double slope = unit * (1.0 + tangent * tangent);
  const double moment = 2.0 * unit * tangent;
  return {2.0 * unit * std::log1p(tangent * tangent) + beyond * (moment + slope * beyond / 2.0),
          std::copysign(moment + slope * beyond, angle), slope};
}

inline HingeLaw hinge_law(double angle, const Material& material) {
  return hinge_law(angle, material, material.rest_length);
}

inline double rest_length_at(Ring ring, const Material& material, std::size_t node) {
  return 0.5 * (material.rest_length_of(ring.previous(node)) + material.rest_length_of(node));
}

}  // namespace rouleau::cells
