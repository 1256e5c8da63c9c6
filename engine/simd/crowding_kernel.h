#pragma once

#include "engine/simd/vector.h"

namespace rouleau::simd {
namespace {

/// Pairs of floats of eight particles, taken apart.
struct Gathered {
  Floats x, y;
};

inline Gathered gather(const float* pairs, const int* id) {
  Floats two[2];
  for (int half = 0; half < 2; ++half) {
    double both[4];
    for (int k = 0; k < 4; ++k) std::memcpy(&both[k], pairs + 2 * id[4 * half + k], sizeof(double));
    two[half] = reinterpret_cast<Floats>(Doubles{both[0], both[1], both[2], both[3]});
  }
  return {__builtin_shufflevector(two[0], two[1], 0, 2, 4, 6, 8, 10, 12, 14),
          __builtin_shufflevector(two[0], two[1], 1, 3, 5, 7, 9, 11, 13, 15)};
}

void crowding(const PairRows& list, const float* dx, const float* dy, const float* moved, float reach,
              float* out) {
  const Floats per_reach = all(1 / reach), tiny = all(1e-9F * reach);
  for (int i = 0; i < list.rows; ++i) {
    const Floats x0 = all(moved[2 * i]), y0 = all(moved[2 * i + 1]);
    Floats sum_x{}, sum_y{};
    for (int k = list.begin[i]; k < list.end[i]; k += lanes) {
      const Gathered there = gather(moved, list.j + k);
      const Floats x = load<Floats>(dx + k) + (there.x - x0);
      const Floats y = load<Floats>(dy + k) + (there.y - y0);
      const Floats r = root(x * x + y * y);
      const Floats q = 1.0F - r * per_reach;
      const Floats f = q * q * q / (r + tiny);
      const Floats push = chosen(q > 0.0F, f, Floats{});
      sum_x -= push * x;
      sum_y -= push * y;
    }
    out[2 * i] = sum_of(sum_x);
    out[2 * i + 1] = sum_of(sum_y);
  }
}

}  // namespace
}  // namespace rouleau::simd
