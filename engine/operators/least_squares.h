#pragma once

#include <vector>

#include "engine/particles/neighbour_list.h"

namespace rouleau::operators {

struct Gradient {
  double x = 0, y = 0;
};

/// Derivatives by a weighted least-squares fit of a quadratic through each active particle: basis
/// {X, Y, X^2, XY, Y^2}, weight (1 - r/re)^2 within the list's radius re. Two fits a particle: for
/// velocities the walls and the inlet are data (u = u_wall), for pressure they are absent. Exact for
/// quadratic fields wherever the neighbourhood carries all five terms; a poor one falls back on a damped
/// fit (velocities) or a linear one (pressure).
class LeastSquares {
 public:
  /// Weights for the present positions. Particles must be sorted as the list was built.
  void build(const particles::ParticleSet& particles, const particles::NeighbourList& list);

  /// Weight of each pair of the list in d/dx, d/dy and the Laplacian of a velocity: [pairs]
  const std::vector<float>& dx() const { return dx_; }
  const std::vector<float>& dy() const { return dy_; }
  const std::vector<float>& laplacian() const { return laplacian_; }

  Gradient velocity_gradient(int i, const double* field) const;
  Gradient pressure_gradient(int i, const double* field) const;

  /// The same in the pressure gradient: [pairs]
  const std::vector<float>& pressure_dx() const { return pressure_dx_; }
  const std::vector<float>& pressure_dy() const { return pressure_dy_; }

  /// Rows whose quadratic fit failed in the last build.
  int poor_rows() const { return poor_rows_; }

 private:
  void fit_row(const particles::NeighbourList& list, int i, int pressure_end);

  const particles::NeighbourList* list_ = nullptr;
  std::vector<float> dx_, dy_, laplacian_;
  std::vector<float> pressure_dx_, pressure_dy_;
  int poor_rows_ = 0;
  // One row's scaled offsets and weights.
  std::vector<float> X_, Y_, w_;
};

}  // namespace rouleau::operators
