#pragma once

#include <vector>

#include "engine/simd/kernels.h"

namespace rouleau::linear {

/// A square matrix as a diagonal and compressed rows of off-diagonal entries, each padded to a multiple of
/// four with zeros. Entries in float: the weights carry no more than that, and the products are summed in
/// double.
struct SparseRows {
  static constexpr int padding = 4;

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
    while (column.size() % padding != 0) add(rows(), 0);
    diagonal.push_back(d);
    begin.push_back(static_cast<int>(column.size()));
  }

  /// Makes room for rows of at most these lengths, to be written in place.
  /// @param length  length(i) of row i
  template <class Length>
  void lay_out(int rows, const Length& length) {
    diagonal.resize(rows);
    begin.resize(rows + 1);
    begin[0] = 0;
    for (int i = 0; i < rows; ++i) begin[i + 1] = begin[i] + (length(i) + padding - 1) / padding * padding;
    column.resize(begin[rows]);
    value.resize(begin[rows]);
  }

  /// Fills what is left of row i from entry `at` on.
  void pad(int i, int at) {
    for (; at < begin[i + 1]; ++at) {
      column[at] = i;
      value[at] = 0;
    }
  }

  /// out = this times in
  void times(const double* in, double* out) const {
    simd::kernels().matrix_products({rows(), begin.data(), column.data(), value.data(), diagonal.data()}, in,
                                    out);
  }
};

}  // namespace rouleau::linear
