#pragma once

namespace rouleau::particles {

/// The shorter way between two particles, across the seam of a periodic direction if that is it. For offsets
/// of less than one and a half periods; period 0: not periodic.
inline double nearest_image(double offset, double period) {
  if (offset > 0.5 * period) return offset - period;
  return offset < -0.5 * period ? offset + period : offset;
}

}  // namespace rouleau::particles
