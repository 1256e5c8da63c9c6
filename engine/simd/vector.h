#pragma once

// The one vector type behind the kernels: eight floats, or four doubles, by GCC's vector extensions, which
// become AVX2 instructions where the compiler may use them and plain ones where not, with the same result.
// Only for the two files that compile the kernels. As each of them is compiled for another processor,
// everything here has internal linkage, and nothing of the standard library is called that has not.

#include <cstdint>
#include <cstring>
#ifdef __AVX2__
#include <array>
#include <immintrin.h>
#endif

#include "engine/simd/kernels.h"

namespace rouleau::simd {
namespace {

using Floats = float __attribute__((vector_size(32)));
using Ints = int __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(32)));
using HalfInts = int __attribute__((vector_size(16)));
using HalfFloats = float __attribute__((vector_size(16)));
using HalfDoubles = double __attribute__((vector_size(16)));

template <class Vector, class Element>
Vector load(const Element* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector, class Element>
void store(Element* to, const Vector& v) {
  std::memcpy(to, &v, sizeof v);
}

inline Floats all(float value) {
  return value - Floats{};
}

inline Doubles all(double value) {
  return value - Doubles{};
}

inline Doubles low_half(Floats v) {
  return __builtin_convertvector(__builtin_shufflevector(v, v, 0, 1, 2, 3), Doubles);
}

inline Doubles high_half(Floats v) {
  return __builtin_convertvector(__builtin_shufflevector(v, v, 4, 5, 6, 7), Doubles);
}

inline Floats root(Floats v) {
#ifdef __AVX2__
  return _mm256_sqrt_ps(v);
#else
  for (int lane = 0; lane < lanes; ++lane) v[lane] = __builtin_sqrtf(v[lane]);
  return v;
#endif
}

inline Floats chosen(Ints mask, Floats yes, Floats no) {
  return reinterpret_cast<Floats>((reinterpret_cast<Ints>(yes) & mask) |
                                  (reinterpret_cast<Ints>(no) & ~mask));
}

/// One bit a lane, of a comparison.
inline unsigned bits(Ints mask) {
#ifdef __AVX2__
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Floats>(mask)));
#else
  unsigned result = 0;
  for (int lane = 0; lane < lanes; ++lane) result |= static_cast<unsigned>(mask[lane] & 1) << lane;
  return result;
#endif
}

#ifdef __AVX2__
/// For every set of lanes the numbers of its lanes, in order, a byte each.
struct LaneNumbers {
  std::uint64_t of[256] = {};
};

constexpr LaneNumbers lane_numbers = [] {
  LaneNumbers numbers;
  for (unsigned set = 0; set < 256; ++set) {
    int at = 0;
    for (unsigned lane = 0; lane < 8; ++lane) {
      if (set >> lane & 1) numbers.of[set] |= static_cast<std::uint64_t>(lane) << (8 * at++);
    }
  }
  return numbers;
}();
#endif

/// Brings lanes out of vectors into successive places: those of a set, in order. Writes eight places.
class Compress {
 public:
  explicit Compress(unsigned set)
#ifdef __AVX2__
      : order_(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(lane_numbers.of[set])))){}
#else
      : set_(set) {
  }
#endif

        template <class Vector, class Element>
        void
        operator()(const Vector& v, Element* to) const {
#ifdef __AVX2__
    store(to, _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(v), order_));
#else
    for (int lane = 0; lane < lanes; ++lane) {
      *to = v[lane];
      to += set_ >> lane & 1;
    }
#endif
  }

 private:
#ifdef __AVX2__
  __m256i order_;
#else
  unsigned set_;
#endif
};

inline Floats add_even_and_odd(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
         __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}

inline Floats add_pairs(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13) +
         __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Lane k of the result is the sum over the lanes of v[k].
inline Floats sums_of(const Floats* v) {
  const Floats low = add_pairs(add_even_and_odd(v[0], v[1]), add_even_and_odd(v[2], v[3]));
  const Floats high = add_pairs(add_even_and_odd(v[4], v[5]), add_even_and_odd(v[6], v[7]));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
         __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
}

inline float sum_of(Floats v) {
  float lane[lanes];
  store(lane, v);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace
}  // namespace rouleau::simd
