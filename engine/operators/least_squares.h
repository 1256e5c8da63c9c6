#pragma once

#include <span>
#include <vector>

#include "engine/particles/neighbour_list.h"

namespace rouleau::operators {

struct Gradient {
  double x = 0, y = 0;
};

/// Derivatives by a weighted least-squares fit through each active particle: basis {X, Y, X^2, XY, Y^2}, and
/// away from walls r^4, too, which takes out the leading error of the Laplacian, re^2 0.029 times that of the
/// Laplacian; weight (1 - r/re)^2 within the list's radius re. Two fits a particle: for velocities the walls
/// and the inlet are data (u = u_wall), for pressure they are absent. Exact for quadratic fields wherever the
/// neighbourhood carries all terms; a poor one falls back on a damped fit (velocities) or a linear one
/// (pressure).
class LeastSquares {
 public:
  /// Weights for the present positions. Particles must be sorted as the list was built; the list must live
  /// until the next build.
  void build(const particles::ParticleSet& particles, const particles::NeighbourList& list);

  /// Weights of particle i's pairs in d/dx, d/dy and the Laplacian of a velocity, in the list's order.
  const float* dx(int i) const { return &dx_[list_->begin(i)]; }
  const float* dy(int i) const { return &dy_[list_->begin(i)]; }
  const float* laplacian(int i) const { return &laplacian_[list_->begin(i)]; }
  /// The same in the gradient of a pressure.
  const float* pressure_dx(int i) const { return &dx_[pressure_begin_[i]]; }
  const float* pressure_dy(int i) const { return &dy_[pressure_begin_[i]]; }

  /// Multiplies the Laplacian's weight of each pair in these rows by the mean of its particles' factors, so
  /// that with a viscosity nu it is div(nu grad u).
  /// @param factor  of all that a pair can point to
  void scale_laplacians(std::span<const int> rows, const std::vector<double>& factor);

  Gradient velocity_gradient(int i, const double* field) const;
  Gradient pressure_gradient(int i, const double* field) const;

  // Of all active particles at once. Velocities are interleaved (u0, v0, u1, v1, ...) and known to all that
  // a pair can point to.

  /// @param[out] out  [rows]
  void divergences(const double* uv, std::vector<double>& out) const;
  /// @param[out] out  [rows][2]: dp/dx, dp/dy
  void pressure_gradients(const double* p, std::vector<double>& out) const;
  /// Of velocities and pressure together.
  /// @param fields  interleaved: u0, v0, p0, any, u1, ...
  /// @param[out] out  [rows][8]: du/dx, dv/dx, dp/dx, -, du/dy, dv/dy, dp/dy, -
  void field_gradients(const double* fields, const double* p, std::vector<double>& out);
  /// @param[out] out  [rows][2]
  /// @param[out] weights  [rows] the sum of each row's weights
  void velocity_laplacians(const double* uv, std::vector<double>& out, std::vector<double>& weights) const;
  /// What neighbours alone contribute to the Laplacian: the sums of weight x neighbour's velocity.
  /// @param[out] out  [rows][2]
  void laplacian_products(const float* uv, float* out) const;

  /// Rows whose quadratic fit failed in the last build.
  int poor_rows() const { return poor_rows_; }

 private:
  void place_pressure_rows(int pressure_end);
  void fit_velocities();
  void fit_pressures(int pressure_end);
  /// Fits the rows that a task chooses, and marks the poor ones.
  void fit(simd::FitTask task);

  const particles::NeighbourList* list_ = nullptr;
  // Rows that see no wall have one set of weights for both; those of the others in the gradient of a pressure
  // stand behind all rows.
  std::vector<float> dx_, dy_, laplacian_;
  std::vector<int> pressure_begin_;
  std::vector<int> all_rows_, open_rows_, walled_rows_, quadratic_rows_;
  std::vector<unsigned char> poor_;
  std::vector<double> walled_gradients_;
  int poor_rows_ = 0;
};

/// Velocities as the kernels take them: u0, v0, u1, v1, ...
void interleave(const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& uv);

}  // namespace rouleau::operators
