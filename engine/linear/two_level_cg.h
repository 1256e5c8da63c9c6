#pragma once

#include <span>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "engine/linear/bicgstab.h"
#include "engine/linear/sparse_rows.h"

namespace rouleau::linear {

/// Conjugate gradients for a symmetric positive definite matrix, preconditioned by Jacobi plus an additive
/// coarse space that is constant on aggregates (numbers of iterations then hardly grow with the vessel).
class TwoLevelCg {
 public:
  /// Prepares for a matrix.
  /// @param aggregate  [rows] which aggregate a row is in, from 0
  void prepare(const SparseRows& matrix, std::span<const int> aggregate, int aggregates);

  /// Solves for x from the x given until the residual is below `tolerance` times the norm of b.
  Solve solve(const SparseRows& matrix, std::span<const double> b, std::span<double> x, double tolerance,
              int max_iterations);

 private:
  /// z = M^-1 r; returns r . z
  double precondition(const SparseRows& matrix);

  std::span<const int> aggregate_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> coarse_;
  bool coarse_usable_ = false;
  Eigen::VectorXd coarse_r_, coarse_z_;
  std::vector<double> r_, z_, p_, q_;
};

}  // namespace rouleau::linear
