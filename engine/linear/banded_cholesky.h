#pragma once

#include <span>
#include <vector>

namespace rouleau::linear {

/// Cholesky factors of a symmetric positive definite matrix whose entries are at most a bandwidth from the
/// diagonal; the lower half is stored. Keeps its memory from matrix to matrix.
class BandedCholesky {
 public:
  /// A matrix of zeros.
  void reset(int rows, int bandwidth);
  /// Entry (i, j) with i - bandwidth <= j <= i.
  double& at(int i, int j) {
    return entries_[static_cast<std::size_t>(i) * (bandwidth_ + 1) + j - i + bandwidth_];
  }
  int rows() const { return rows_; }
  int bandwidth() const { return bandwidth_; }

  /// Replaces the matrix by its factor.
  /// @return whether it was positive definite
  bool factor();
  /// Solves in place, with the factor.
  void solve(std::span<double> b) const;

 private:
  const double* row(int i) const { return &entries_[static_cast<std::size_t>(i) * (bandwidth_ + 1)]; }

  int rows_ = 0, bandwidth_ = 0;
  std::vector<double> entries_;  ///< [rows][bandwidth + 1], the diagonal last
  std::vector<double> inverse_;  ///< of the factor's diagonal
};

}  // namespace rouleau::linear
