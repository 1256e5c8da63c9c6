#pragma once

#include <span>
#include <vector>

#include "engine/linear/bicgstab.h"
#include "engine/linear/coarse_space.h"
#include "engine/linear/sparse_rows.h"

namespace rouleau::linear {

/// What a matrix does to a vector of equal entries.
enum class Constants {
  seen,     ///< it is positive definite
  ignored,  ///< every row adds up to 0: solutions are known but for a constant
};

/// Conjugate gradients for a symmetric positive definite matrix, preconditioned by Jacobi plus an additive
/// coarse space that is constant on aggregates (numbers of iterations then hardly grow with the vessel).
/// Where the matrix ignores constants the right-hand side is freed of its mean, and so is the solution.
class TwoLevelCg {
 public:
  /// Prepares for a matrix; both must live until the last solve.
  void prepare(const SparseRows& matrix, const Aggregates& aggregates, Constants constants = Constants::seen);

  /// Solves for x from the x given until the residual is below `tolerance` times the norm of b.
  Solve solve(std::span<const double> b, std::span<double> x, double tolerance, int max_iterations);

 private:
  void prepare_coarse();
  /// Works out the coarse part of z = M^-1 r; returns r . z
  double precondition();
  void centre(std::span<double> vector) const;

  const SparseRows* matrix_ = nullptr;
  const Aggregates* aggregates_ = nullptr;
  Constants constants_ = Constants::seen;
  CoarseSpace coarse_;
  std::vector<double> inverse_diagonal_;
  std::vector<double> r_, z_, p_, q_;
};

}  // namespace rouleau::linear
