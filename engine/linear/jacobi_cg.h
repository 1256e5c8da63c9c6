#pragma once

#include <span>
#include <vector>

#include "engine/linear/bicgstab.h"
#include "engine/linear/sparse_rows.h"

namespace rouleau::linear {

/// Conjugate gradients for a symmetric positive definite matrix, preconditioned by its diagonal and nothing
/// else: the published scheme's solver. Keeps its vectors from solve to solve.
class JacobiCg {
 public:
  /// Solves for x from the x given until the residual is below `tolerance` times the norm of b.
  Solve solve(const SparseRows& matrix, std::span<const double> b, std::span<double> x, double tolerance,
              int max_iterations);

 private:
  double true_residual(const SparseRows& matrix, std::span<const double> b, std::span<const double> x);

  std::vector<double> r_, z_, p_, q_;
};

}  // namespace rouleau::linear
