#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/linear/aggregates.h"
#include "engine/linear/banded_cholesky.h"

namespace rouleau::linear {

/// Corrections that are constant on aggregates: the part of a two-level preconditioner that takes out the
/// smooth error. Keeps its memory from matrix to matrix.
class CoarseSpace {
 public:
  /// Begins a matrix of zeros. The aggregates must live until the last use.
  void reset(const Aggregates& aggregates);
  /// Adds to the entry between two aggregates, or of one; of those of (a, b) and (b, a) the mean counts.
  void add(int a, int b, double value) { entries_[place(a, b)] += value; }
  /// @param constants_ignored  every row of the matrix adds up to 0: it is made definite
  void factor(bool constants_ignored = false);

  /// The corrections for a residual r[rows * stride], of its component `component`.
  template <class Real>
  std::span<const double> correct(std::span<const Real> r, int stride = 1, int component = 0);

 private:
  std::size_t place(int a, int b) const {
    const int bandwidth = matrix_.bandwidth();
    return static_cast<std::size_t>(a) * (2 * bandwidth + 1) + b - a + bandwidth;
  }

  const Aggregates* aggregates_ = nullptr;
  std::vector<double> entries_;  ///< [aggregates][2 bandwidth + 1]
  BandedCholesky matrix_;
  bool usable_ = false;
  std::vector<double> sums_;
};

template <class Real>
std::span<const double> CoarseSpace::correct(std::span<const Real> r, int stride, int component) {
  sums_.assign(matrix_.rows(), 0);
  if (!usable_) return sums_;
  // Neighbours in memory mostly share an aggregate: their sum is kept in a register.
  const std::vector<int>& of = aggregates_->of;
  for (std::size_t i = 0; i < of.size();) {
    const int a = of[i];
    double sum = 0;
    for (; i < of.size() && of[i] == a; ++i) sum += r[i * stride + component];
    sums_[a] += sum;
  }
  matrix_.solve(sums_);
  return sums_;
}

}  // namespace rouleau::linear
