#pragma once

#include <vector>

#include "engine/geometry/shapes.h"
#include "engine/geometry/wall_distance.h"

namespace rouleau::geometry {

/// A straight stretch of wall from corner to corner, with the fluid on its left, and what stands on it.
struct WallLeg {
  Point from{}, to{};
  double speed = 0;           ///< of the wall along itself
  std::vector<Bump> bumps{};  ///< in order from `from` to `to`
};

/// What is behind the leg and its prolongations.
HalfPlane behind(const WallLeg& leg);

/// Straight pieces and arcs by turns along the legs, each of which begins where the last one ends.
WallChain chain_of(const std::vector<WallLeg>& legs, bool loop);

/// The wall of a periodic vessel. It has no corner at the seam: with a thrombus it starts at the foot of the
/// first one.
WallChain periodic_chain(const WallLeg& leg);

}  // namespace rouleau::geometry
