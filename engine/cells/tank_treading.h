#pragma once

#include <span>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// How far and how fast a membrane has turned around its shape. With the nodes as complex numbers z_j, their
/// places along the unstretched membrane as s_j = 2 pi j / n, and Z+ and Z- the means of z_j exp(-i s_j) and
/// z_j exp(i s_j) (the ellipse in the elliptic Fourier descriptors of Kuhl and Giardina, Comput. Graph. Image
/// Process. 18, 236 (1982)): a membrane at phase psi around an ellipse inclined by theta has
/// arg Z+ = theta + psi and arg Z- = theta - psi. Rigid rotation, as in tumbling, leaves psi as it is.
/// Within 1 % of a circle (|Z-| < 0.01 |Z+|) there is no inclination, and psi is arg Z+.
struct TankTreading {
  double phase;      ///< psi, degrees in (-90, 90]: as the axis it is counted from, it has no direction
  double frequency;  ///< revolutions per unit of time, counter-clockwise ones positive
};

/// @param u, v  velocities of the nodes
TankTreading tank_treading(Ring ring, std::span<const double> u, std::span<const double> v);

/// An angle of an axis, in degrees, brought to (-90, 90].
double axis_angle(double degrees);

}  // namespace rouleau::cells
