#include "engine/simd/kernels.h"

namespace rouleau::simd {

namespace {

Path& chosen_path() {
  static Path path = available(Path::avx2) ? Path::avx2 : Path::plain;
  return path;
}

}  // namespace

bool available(Path path) {
#ifdef ROULEAU_AVX2_KERNELS
  return path == Path::plain || __builtin_cpu_supports("avx2");
#else
  return path == Path::plain;
#endif
}

Path path() {
  return chosen_path();
}

void choose(Path path) {
  chosen_path() = available(path) ? path : Path::plain;
}

const Kernels& kernels() {
#ifdef ROULEAU_AVX2_KERNELS
  if (chosen_path() == Path::avx2) return avx2_kernels;
#endif
  return plain_kernels;
}

}  // namespace rouleau::simd
