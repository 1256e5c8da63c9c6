#include "engine/linear/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace rouleau::linear {

void BandedCholesky::reset(int rows, int bandwidth) {
  rows_ = rows;
  bandwidth_ = bandwidth;
  entries_.assign(static_cast<std::size_t>(rows) * (bandwidth + 1), 0);
  inverse_.resize(rows);
}

bool BandedCholesky::factor() {
  const int w = bandwidth_;
  for (int i = 0; i < rows_; ++i) {
    double* li = &entries_[static_cast<std::size_t>(i) * (w + 1)] + w;  // li[j - i] is entry (i, j)
    const int first = std::max(0, i - w);
    for (int j = first; j <= i; ++j) {
      const double* lj = row(j) + w;
      double sum = li[j - i];
      for (int k = std::max(first, j - w); k < j; ++k) sum -= li[k - i] * lj[k - j];
      if (j < i) {
        li[j - i] = sum * inverse_[j];
      } else {
        if (!(sum > 0)) return false;
        li[0] = std::sqrt(sum);
        inverse_[i] = 1 / li[0];
      }
    }
  }
  return true;
}

void BandedCholesky::solve(std::span<double> b) const {
  const int w = bandwidth_;
  for (int i = 0; i < rows_; ++i) {
    const double* li = row(i) + w;
    double sum = b[i];
    for (int k = std::max(0, i - w); k < i; ++k) sum -= li[k - i] * b[k];
    b[i] = sum * inverse_[i];
  }
  for (int i = rows_ - 1; i >= 0; --i) {
    const double* li = row(i) + w;
    b[i] *= inverse_[i];
    for (int k = std::max(0, i - w); k < i; ++k) b[k] -= li[k - i] * b[i];
  }
}

}  // namespace rouleau::linear
