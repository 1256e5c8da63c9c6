#pragma once

#include <span>
#include <vector>

namespace rouleau::linear {

/// A square matrix as a diagonal and compressed rows of off-diagonal entries. Entries in float: the weights
/// carry no more than that, and the products are summed in double.
struct SparseRows {
  std::vector<double> diagonal;  ///< [rows]
  std::vector<int> begin;        ///< [rows + 1]
  std::vector<int> column;       ///< [entries]
  std::vector<float> value;      ///< [entries]

  int rows() const { return static_cast<int>(diagonal.size()); }

  void clear() {
    diagonal.clear();
    begin.assign(1, 0);
    column.clear();
    value.clear();
  }

  void add(int j, float a) {
    column.push_back(j);
    value.push_back(a);
  }

  void end_row(double d) {
    diagonal.push_back(d);
    begin.push_back(static_cast<int>(column.size()));
  }

  double row_times(int i, const double* in) const {
    double sum = diagonal[i] * in[i];
    const int* j = column.data();
    const float* a = value.data();
#pragma omp simd reduction(+ : sum)
    for (int k = begin[i]; k < begin[i + 1]; ++k) sum += a[k] * in[j[k]];
    return sum;
  }
};

}  // namespace rouleau::linear
