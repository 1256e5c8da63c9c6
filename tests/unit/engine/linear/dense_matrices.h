#pragma once

#include <Eigen/Dense>

#include "engine/linear/sparse_rows.h"

namespace rouleau::linear {

/// The rows of a dense matrix, as the solvers take them.
inline SparseRows sparse(const Eigen::MatrixXd& a) {
  SparseRows rows;
  rows.clear();
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.cols(); ++j) {
      if (i != j && a(i, j) != 0) rows.add(j, static_cast<float>(a(i, j)));
    }
    rows.end_row(a(i, i));
  }
  return rows;
}

/// Symmetric, exact in float, its eigenvalues from `least` up.
inline Eigen::MatrixXd random_symmetric(int n, double least) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
  a = (a + a.transpose()).eval().cast<float>().cast<double>();
  const double lowest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a).eigenvalues()[0];
  a.diagonal().array() += least - lowest;
  return a;
}

}  // namespace rouleau::linear
