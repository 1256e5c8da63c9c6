#pragma once

#include <vector>

#include "engine/operators/least_squares.h"
#include "engine/particles/neighbour_list.h"

namespace rouleau::operators {

/// The published scheme's kernel and the constants that go with it on a square lattice.
class StandardMps {
 public:
  /// @param radius  r_c of the kernel, in the unit of `spacing`
  StandardMps(double spacing, double radius);

  double radius() const { return radius_; }
  double density() const { return density_; }             ///< n0: eq. 8 on the lattice
  double square_distance() const { return lambda_; }      ///< lambda0: mean of r^2, weighted by the kernel
  double gradient_scale() const { return 2 / density_; }  ///< d/n0 of eq. 5
  double laplacian_scale() const { return 4 / (density_ * lambda_); }  ///< 2d/(n0 lambda0) of eqs. 6 and 9

  /// Kernel, eq. 4: r_c/r - 1 within r_c.
  double weight(double r) const { return r < radius_ ? radius_ / r - 1 : 0; }

  /// The longest explicit step of diffusion that damps every mode on the lattice.
  double largest_step(double viscosity) const { return lambda_ / (4 * viscosity); }

 private:
  double radius_;
  double density_ = 0;
  double lambda_ = 0;
};

/// The kernel of every pair of a list: [pairs], and of its ghosts: [ghost pairs].
struct KernelWeights {
  std::vector<float> pair, ghost;

  void fill(const StandardMps& mps, const particles::NeighbourList& list);
};

/// Particle number density at row i, eq. 8.
double number_density(const particles::NeighbourList& list, const KernelWeights& weights, int i);

/// Gradient of a field at row i, eq. 5, with `base` in place of phi_i. Ghosts carry no field.
Gradient gradient(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                  int i, const double* field, double base);

/// Divergence of a velocity at row i, by eq. 5.
double divergence(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                  int i, const double* u, const double* v);

/// Laplacian of a field at row i, eq. 6, ghosts included.
double laplacian(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                 int i, const double* field);

}  // namespace rouleau::operators
