# What every target of ours is compiled with. -ffast-math is nowhere: a NaN must be seen.
# -fopenmp-simd only honours `#pragma omp simd`; it brings in no OpenMP runtime.
add_library(rouleau_flags INTERFACE)
target_compile_options(
  rouleau_flags
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wno-sign-conversion
            -Werror
            -Wno-restrict  # GCC 12 sees overlap in "text" + std::string() (its bug 105651)
            -fopenmp-simd
            -fno-math-errno
            -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # It builds the fuzzers alone: what only Clang warns of stays a warning, and so do options that it does not know.
  target_compile_options(rouleau_flags INTERFACE -Wno-error -Wno-unknown-warning-option)
endif()
if(ROULEAU_NATIVE)
  # GCC 12 warns of its own AVX-512 intrinsics (its bug 105593).
  target_compile_options(rouleau_flags INTERFACE -march=native -Wno-maybe-uninitialized)
endif()
if(ROULEAU_SANITIZE)
  # Under the sanitizers GCC 12 warns of its own <regex>.
  add_compile_options(-fsanitize=${ROULEAU_SANITIZE} -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=${ROULEAU_SANITIZE})
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  add_compile_options(-O3)
endif()
