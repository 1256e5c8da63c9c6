#pragma once

namespace rouleau {

/// A change of the spacing, or of a membrane's nodes alone, and the cell that called for it.
struct Refinement {
  double time = 0;  ///< s
  int cell = 0;
  double spacing = 0;  ///< d0 from then on, m
};

}  // namespace rouleau
