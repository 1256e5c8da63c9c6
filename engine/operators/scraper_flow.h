#pragma once

#include <vector>

#include "engine/geometry/shapes.h"

namespace rouleau::operators {

/// Velocity and pressure of a flow that is known.
struct KnownFlow {
  double u = 0, v = 0;
  double p = 0;  ///< over the viscosity (kinematic, where the density is 1)
};

/// Stokes flow in the right-angled corners between walls that move along themselves: G. I. Taylor's scraper
/// (1962). Near such a corner every flow is like it: the velocity jumps there and the pressure goes as 1/r,
/// which no fit can follow. Free of divergence, and nu times its Laplacian is the gradient of its pressure.
class ScraperFlow {
 public:
  /// Of all corners between two straight pieces of the walls, of which one at least moves.
  explicit ScraperFlow(const std::vector<geometry::WallChain>& walls);

  bool any() const { return !corners_.empty(); }
  /// Nothing in a corner itself.
  KnownFlow at(double x, double y) const;

 private:
  struct Corner {
    geometry::Point at;
    double tx, ty;    ///< along the wall that leaves the corner, the fluid on its left
    double leaving;   ///< speed of that wall, away from the corner
    double arriving;  ///< speed of the other one, away from the corner
  };
  std::vector<Corner> corners_;
};

}  // namespace rouleau::operators
