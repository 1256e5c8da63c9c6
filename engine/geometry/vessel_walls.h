#pragma once

#include <vector>

#include "engine/case/case.h"
#include "engine/geometry/shapes.h"
#include "engine/geometry/wall_distance.h"

namespace rouleau::geometry {

/// What a case makes of a vessel. What is not fluid is the union of convex solids (half planes, wedges and
/// discs), so that in the fluid the distance to the walls is the least of the distances to them.
struct VesselWalls {
  double length = 0, height = 0;
  double period_x = 0, period_y = 0;
  std::vector<WallChain> chains;
  std::vector<HalfPlane> planes;
  std::vector<Wedge> wedges;
  std::vector<Bump> bumps;
  std::vector<Opening> inlets, outlets;
  Bounds bounds;
  double area = 0;
  double narrowest = 0;
};

/// The vessel and its thrombi, which must be as `read_case` accepts them, in units of `unit_length` and
/// `unit_velocity` (SI values of one unit).
VesselWalls walls_of(const Case& scene, double unit_length, double unit_velocity);

}  // namespace rouleau::geometry
