#pragma once

#include <array>

#include "engine/case/case.h"

namespace rouleau {

/// All points within `radius` of the segment from `from` to `to`. SI units.
struct Capsule {
  std::array<double, 2> from;
  std::array<double, 2> to;
  double radius = 0;
};

/// A capsule that holds the shape that the cell starts with, wherever the scene puts it: what the checks of a
/// scene take for the cell before anything is computed.
Capsule cell_envelope(const RedCell& cell);

/// Least distance between what the capsules' axes pass through; less than the radii together is an overlap.
double axis_distance(const Capsule& capsule, const std::array<double, 2>& point);
double axis_distance(const Capsule& one, const Capsule& other);

}  // namespace rouleau
