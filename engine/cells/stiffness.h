#pragma once

#include <array>

namespace rouleau::cells {

/// A term of rank one of an elastic stiffness in the Gauss-Newton sense: moving its three nodes by du changes
/// their forces by df = -k g (g . du). It is symmetric and, as k >= 0, never feeds energy in; what makes the
/// exact stiffness indefinite (the turning of a compressed link, of a bent hinge) is left out.
struct Stiffness {
  std::array<int, 3> node;  ///< an element of two nodes repeats the second one
  std::array<double, 6> g;  ///< x0, y0, x1, y1, x2, y2; 0 for a repeated node
  double k;
};

}  // namespace rouleau::cells
