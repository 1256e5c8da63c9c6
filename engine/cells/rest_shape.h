#pragma once

#include <stdexcept>
#include <vector>

#include "engine/cells/material.h"

namespace rouleau::cells {

/// No rest shape was found: the request cannot be met, or the iteration did not converge.
struct RestShapeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A force-free ring, counter-clockwise, its area's centroid at the origin and its long axis along x.
/// The link from the last node to node 0 crosses the positive x axis.
struct RestShape {
  std::vector<double> x, y;
  double area, perimeter;
  int iterations;
};

/// The shape of least stretch and bending energy that `nodes` nodes take at exactly the given area (relative
/// error below 1e-10), symmetric about the x axis. A membrane soft in stretch may stay round under
/// compression instead of buckling; from the area of the unstretched circle on it is an inflated regular
/// polygon. Throws RestShapeError on a modulus, length or area that is not positive, on fewer than eight
/// nodes, when the cell is so deflated that its two sides would cross, and when Newton's iteration does not
/// converge.
RestShape rest_shape(const Material& material, int nodes, double area);

}  // namespace rouleau::cells
