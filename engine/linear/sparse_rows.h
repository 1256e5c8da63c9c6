#pragma once

#include <array>
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

  /// Entry i of the product with `in`. Four sums at once, since each is a chain of dependent additions, and
  /// plain loads, which are faster than gathers.
  double row_times(int i, const double* in) const {
    std::array<double, 4> sum{diagonal[i] * in[i], 0, 0, 0};
    const int end = begin[i + 1];
    int k = begin[i];
    for (; k + 4 <= end; k += 4) {
      for (int lane = 0; lane < 4; ++lane) sum[lane] += value[k + lane] * in[column[k + lane]];
    }
    for (; k < end; ++k) sum[0] += value[k] * in[column[k]];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
};

}  // namespace rouleau::linear
