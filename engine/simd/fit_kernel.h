#pragma once

#include "engine/simd/vector.h"

namespace rouleau::simd {
namespace {

// The basis is X, Y, X^2, XY, Y^2 and, in fits that are asked for it, r^4.
constexpr int quadratic = 5, with_quartic = 6;
constexpr int moments_of(int terms) {
  return terms == quadratic ? 12 : 18;
}
constexpr double least_pivot = 1e-6;

/// Offsets in units of half the radius, which keep the moments near one, and the weight.
struct Scaled {
  Floats X, Y, w;
};

inline Scaled scaled(const PairRows& list, const PairOffsets& offsets, const FitTask& task, int k) {
  const float per_radius = 1 / task.radius;
  const Floats q = 1.0F - load<Floats>(offsets.r + k) * per_radius;
  const Ints counts = load<Ints>(list.j + k) < task.j_end;
  return {load<Floats>(offsets.dx + k) * (2 * per_radius), load<Floats>(offsets.dy + k) * (2 * per_radius),
          chosen(counts, q * q, Floats{})};
}

/// Moments m20, m11, m02, m30, m21, m12, m03, m40, m31, m22, m13, m04 of one row, still in eight parts, and
/// those of r^4 with the basis.
template <int terms>
inline void add_moments(const PairRows& list, const PairOffsets& offsets, const FitTask& task, int row,
                        Floats (*sum)[lanes], int lane) {
  Floats m20{}, m11{}, m02{}, m30{}, m21{}, m12{}, m03{}, m40{}, m31{}, m22{}, m13{}, m04{};
  Floats r10{}, r01{}, r20{}, r11{}, r02{}, r40{};
  for (int k = list.begin[row]; k < list.end[row]; k += lanes) {
    const auto [X, Y, w] = scaled(list, offsets, task, k);
    const Floats xx = X * X, xy = X * Y, yy = Y * Y;
    const Floats wxx = w * xx, wxy = w * xy, wyy = w * yy;
    m20 += wxx;
    m11 += wxy;
    m02 += wyy;
    m30 += wxx * X;
    m21 += wxx * Y;
    m12 += wyy * X;
    m03 += wyy * Y;
    m40 += wxx * xx;
    m31 += wxx * xy;
    m22 += wxx * yy;
    m13 += wyy * xy;
    m04 += wyy * yy;
    if constexpr (terms == with_quartic) {
      const Floats square = xx + yy, fourth = square * square, weighted = w * fourth;
      r10 += weighted * X;
      r01 += weighted * Y;
      r20 += weighted * xx;
      r11 += weighted * xy;
      r02 += weighted * yy;
      r40 += weighted * fourth;
    }
  }
  const Floats all_of_row[] = {m20, m11, m02, m30, m21, m12, m03, m40, m31,
                               m22, m13, m04, r10, r01, r20, r11, r02, r40};
  for (int m = 0; m < moments_of(terms); ++m) sum[m][lane] = all_of_row[m];
}

/// Eight doubles, a lane a row.
struct Octet {
  Doubles low, high;

  friend Octet operator+(Octet a, Octet b) { return {a.low + b.low, a.high + b.high}; }
  friend Octet operator-(Octet a, Octet b) { return {a.low - b.low, a.high - b.high}; }
  friend Octet operator*(Octet a, Octet b) { return {a.low * b.low, a.high * b.high}; }
  double operator[](int lane) const { return lane < 4 ? low[lane] : high[lane - 4]; }
};

inline Octet octet(double value) {
  return {all(value), all(value)};
}

inline Octet inverse(Octet v) {
  return {1.0 / v.low, 1.0 / v.high};
}

/// Normal matrices of eight rows, factored as L D L^T.
template <int terms>
class NormalMatrices {
 public:
  explicit NormalMatrices(const Octet* m) {
    const Octet a[with_quartic][with_quartic] = {{m[0]},
                                                 {m[1], m[2]},
                                                 {m[3], m[4], m[7]},
                                                 {m[4], m[5], m[8], m[9]},
                                                 {m[5], m[6], m[9], m[10], m[11]},
                                                 {m[12], m[13], m[14], m[15], m[16], m[17]}};
    for (int i = 0; i < terms; ++i) {
      Octet scaled_l[terms];
      Octet pivot = a[i][i];
      for (int j = 0; j < i; ++j) {
        Octet s = a[i][j];
        for (int k = 0; k < j; ++k) s = s - scaled_l[k] * l_[j][k];
        scaled_l[j] = s;
        l_[i][j] = s * inverse_[j];
        pivot = pivot - s * l_[i][j];
      }
      least_[i] = pivot;
      inverse_[i] = inverse(pivot);
    }
  }

  bool sound(int lane) const {
    bool sound = true;
    for (int i = 0; i < terms; ++i) sound &= least_[i][lane] > least_pivot;
    return sound;
  }

  /// Solves for a right-hand side that begins with `zeros` zeros.
  void solve(Octet* b, int zeros) const {
    for (int i = zeros + 1; i < terms; ++i) {
      for (int k = zeros; k < i; ++k) b[i] = b[i] - l_[i][k] * b[k];
    }
    for (int i = zeros; i < terms; ++i) b[i] = b[i] * inverse_[i];
    for (int i = terms - 2; i >= 0; --i) {
      for (int k = i + 1; k < terms; ++k) b[i] = b[i] - l_[k][i] * b[k];
    }
  }

 private:
  Octet l_[terms][terms];
  Octet inverse_[terms];
  Octet least_[terms];
};

constexpr int derivatives = 3;

/// The derivatives' coefficients in the basis, of eight rows; scaled back to lengths.
template <int terms>
inline void coefficients(const NormalMatrices<terms>& matrices, double scale, Octet (*c)[terms]) {
  for (int d = 0; d < derivatives; ++d) {
    for (int q = 0; q < terms; ++q) c[d][q] = octet(0);
  }
  c[0][0] = octet(scale);
  c[1][1] = octet(scale);
  c[2][2] = c[2][4] = octet(2 * scale * scale);
  for (int d = 0; d < derivatives; ++d) matrices.solve(c[d], d);
}

template <int terms, int count>
void write_weights(const PairRows& list, const PairOffsets& offsets, const FitTask& task, int row,
                   const Octet (*c)[terms], int lane) {
  Floats factor[count][terms];
  for (int d = 0; d < count; ++d) {
    for (int q = 0; q < terms; ++q) factor[d][q] = all(static_cast<float>(c[d][q][lane]));
  }
  float* const out[derivatives] = {task.dx, task.dy, task.laplacian};
  const int shift = task.choice.weight_begin[row] - list.begin[row];
  for (int k = list.begin[row]; k < list.end[row]; k += lanes) {
    const auto [X, Y, w] = scaled(list, offsets, task, k);
    const Floats xx = X * X, xy = X * Y, yy = Y * Y;
    for (int d = 0; d < count; ++d) {
      const Floats* f = factor[d];
      Floats value = (f[0] * X + f[1] * Y) + (f[2] * xx + (f[3] * xy + f[4] * yy));
      if constexpr (terms == with_quartic) value = value + f[5] * ((xx + yy) * (xx + yy));
      store(out[d] + shift + k, w * value);
    }
  }
}

template <int terms>
void fit_terms(const PairRows& list, const PairOffsets& offsets, const FitTask& task) {
  for (int from = 0; from < task.choice.rows; from += lanes) {
    Floats parts[moments_of(with_quartic)][lanes]{};
    const int rows = task.choice.rows - from < lanes ? task.choice.rows - from : lanes;
    for (int lane = 0; lane < rows; ++lane) {
      add_moments<terms>(list, offsets, task, task.choice.row[from + lane], parts, lane);
    }
    Octet m[moments_of(with_quartic)]{};
    for (int q = 0; q < moments_of(terms); ++q) {
      const Floats sum = sums_of(parts[q]);
      m[q] = {low_half(sum), high_half(sum)};
    }
    const NormalMatrices<terms> matrices(m);
    Octet c[derivatives][terms];
    coefficients<terms>(matrices, 2 / static_cast<double>(task.radius), c);
    for (int lane = 0; lane < rows; ++lane) {
      const int row = task.choice.row[from + lane];
      task.poor[from + lane] = !matrices.sound(lane);
      if (task.poor[from + lane]) continue;
      if (task.laplacian) {
        write_weights<terms, 3>(list, offsets, task, row, c, lane);
      } else {
        write_weights<terms, 2>(list, offsets, task, row, c, lane);
      }
    }
  }
}

void fit(const PairRows& list, const PairOffsets& offsets, const FitTask& task) {
  task.quartic ? fit_terms<with_quartic>(list, offsets, task) : fit_terms<quadratic>(list, offsets, task);
}

}  // namespace
}  // namespace rouleau::simd
