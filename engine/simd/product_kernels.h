#pragma once

#include "engine/simd/vector.h"

namespace rouleau::simd {
namespace {

/// Four indices by two loads: loads are what the sums below wait for.
struct FourIndices {
  std::uint64_t a, b, c, d;

  explicit FourIndices(const int* j) {
    std::uint64_t both[2];
    std::memcpy(both, j, sizeof both);
    a = static_cast<std::uint32_t>(both[0]);
    b = both[0] >> 32;
    c = static_cast<std::uint32_t>(both[1]);
    d = both[1] >> 32;
  }
};

/// (u, v) of two particles.
inline Doubles two_of(const double* uv, std::uint64_t a, std::uint64_t b) {
  const auto first = load<HalfDoubles>(uv + 2 * a), second = load<HalfDoubles>(uv + 2 * b);
  return __builtin_shufflevector(first, second, 0, 1, 2, 3);
}

/// Four weights, each for the u and the v of a particle.
struct Doubled {
  Doubles first, second;
};

inline Doubled doubled(const float* weight) {
  const Doubles w = __builtin_convertvector(load<HalfFloats>(weight), Doubles);
  return {__builtin_shufflevector(w, w, 0, 0, 1, 1), __builtin_shufflevector(w, w, 2, 2, 3, 3)};
}

inline void store_sum(double* out, Doubles a, Doubles b) {
  const Doubles sum = a + b;
  out[0] = sum[0] + sum[2];
  out[1] = sum[1] + sum[3];
}

inline double sum_of(Doubles v) {
  return (v[0] + v[1]) + (v[2] + v[3]);
}

void divergences(const PairRows& list, const float* dx, const float* dy, const double* uv, double* out) {
  for (int i = 0; i < list.rows; ++i) {
    const Doubles here = two_of(uv, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(i));
    Doubles sum1{}, sum2{};
    for (int k = list.begin[i]; k < list.end[i]; k += 4) {
      const FourIndices j(list.j + k);
      const HalfFloats x = load<HalfFloats>(dx + k), y = load<HalfFloats>(dy + k);
      const HalfFloats w1 = __builtin_shufflevector(x, y, 0, 4, 1, 5);
      const HalfFloats w2 = __builtin_shufflevector(x, y, 2, 6, 3, 7);
      sum1 += __builtin_convertvector(w1, Doubles) * (two_of(uv, j.a, j.b) - here);
      sum2 += __builtin_convertvector(w2, Doubles) * (two_of(uv, j.c, j.d) - here);
    }
    out[i] = sum_of(sum1 + sum2);
  }
}

void field_gradients(const PairRows& list, const float* dx, const float* dy, const double* fields,
                     double* out) {
  for (int i = 0; i < list.rows; ++i) {
    const auto here = load<Doubles>(fields + 4 * i);
    Doubles x1{}, x2{}, y1{}, y2{};
    for (int k = list.begin[i]; k < list.end[i]; k += 2) {
      const Doubles first = load<Doubles>(fields + 4 * list.j[k]) - here;
      const Doubles second = load<Doubles>(fields + 4 * list.j[k + 1]) - here;
      x1 += static_cast<double>(dx[k]) * first;
      y1 += static_cast<double>(dy[k]) * first;
      x2 += static_cast<double>(dx[k + 1]) * second;
      y2 += static_cast<double>(dy[k + 1]) * second;
    }
    store(out + 8 * i, x1 + x2);
    store(out + 8 * i + 4, y1 + y2);
  }
}

void velocity_laplacians(const PairRows& list, const float* laplacian, const double* uv, double* out,
                         double* weights) {
  for (int i = 0; i < list.rows; ++i) {
    const Doubles here = two_of(uv, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(i));
    Doubles sum1{}, sum2{}, total{};
    for (int k = list.begin[i]; k < list.end[i]; k += 4) {
      const FourIndices j(list.j + k);
      const Doubled w = doubled(laplacian + k);
      sum1 += w.first * (two_of(uv, j.a, j.b) - here);
      sum2 += w.second * (two_of(uv, j.c, j.d) - here);
      total += w.first + w.second;
    }
    store_sum(out + 2 * i, sum1, sum2);
    weights[i] = total[0] + total[2];
  }
}

/// (u, v) of four particles, in float.
inline Floats four_pairs(const float* uv, const FourIndices& j) {
  double both[4];
  std::memcpy(both, uv + 2 * j.a, sizeof(double));
  std::memcpy(both + 1, uv + 2 * j.b, sizeof(double));
  std::memcpy(both + 2, uv + 2 * j.c, sizeof(double));
  std::memcpy(both + 3, uv + 2 * j.d, sizeof(double));
  return reinterpret_cast<Floats>(Doubles{both[0], both[1], both[2], both[3]});
}

inline Floats doubled_in_float(const float* weight) {
  const auto w = load<HalfFloats>(weight);
  return __builtin_shufflevector(w, w, 0, 0, 1, 1, 2, 2, 3, 3);
}

void velocity_products(const PairRows& list, const float* weight, const float* uv, float* out) {
  for (int i = 0; i < list.rows; ++i) {
    Floats sum1{}, sum2{};
    for (int k = list.begin[i]; k < list.end[i]; k += lanes) {
      sum1 += doubled_in_float(weight + k) * four_pairs(uv, FourIndices(list.j + k));
      sum2 += doubled_in_float(weight + k + 4) * four_pairs(uv, FourIndices(list.j + k + 4));
    }
    float lane[lanes];
    store(lane, sum1 + sum2);
    out[2 * i] = (lane[0] + lane[2]) + (lane[4] + lane[6]);
    out[2 * i + 1] = (lane[1] + lane[3]) + (lane[5] + lane[7]);
  }
}

inline Doubles four_of(const double* f, const FourIndices& j) {
  return Doubles{f[j.a], f[j.b], f[j.c], f[j.d]};
}

void gradients(const PairRows& list, const RowChoice& choice, const float* dx, const float* dy,
               const double* f, double* out) {
  for (int at = 0; at < choice.rows; ++at) {
    const int i = choice.row[at];
    const Doubles here = all(f[i]);
    const int n = list.end[i] - list.begin[i];
    const float* wx = dx + choice.weight_begin[i];
    const float* wy = dy + choice.weight_begin[i];
    Doubles sum_x{}, sum_y{};
    for (int k = 0; k < n; k += 4) {
      const Doubles difference = four_of(f, FourIndices(list.j + list.begin[i] + k)) - here;
      sum_x += __builtin_convertvector(load<HalfFloats>(wx + k), Doubles) * difference;
      sum_y += __builtin_convertvector(load<HalfFloats>(wy + k), Doubles) * difference;
    }
    out[2 * at] = sum_of(sum_x);
    out[2 * at + 1] = sum_of(sum_y);
  }
}

void matrix_products(const MatrixRows& matrix, const double* in, double* out) {
  for (int i = 0; i < matrix.rows; ++i) {
    Doubles sum{};
    for (int k = matrix.begin[i]; k < matrix.begin[i + 1]; k += 4) {
      sum += __builtin_convertvector(load<HalfFloats>(matrix.value + k), Doubles) *
             four_of(in, FourIndices(matrix.column + k));
    }
    out[i] = matrix.diagonal[i] * in[i] + sum_of(sum);
  }
}

}  // namespace
}  // namespace rouleau::simd
