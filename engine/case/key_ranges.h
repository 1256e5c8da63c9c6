#pragma once

#include "engine/case/case_keys.h"

namespace rouleau {

/// Ranges as the table of keys writes them.

inline Range above(double least, double most) {
  return {.least = least, .most = most, .above_least = true};
}

inline Range within(double least, double most) {
  return {.least = least, .most = most};
}

inline Range only(double value) {
  return {.least = value, .most = value};
}

/// Of anything in a vessel: longer than nothing and shorter than a metre.
inline Range length_range() {
  return {.least = 0, .most = 1, .above_least = true, .below_most = true};
}

}  // namespace rouleau
