#pragma once

#include <cmath>

#include "engine/geometry/shapes.h"

namespace rouleau::geometry {

/// Distance to the nearest wall: positive in the fluid, with the unit normal that leads away from the wall.
struct WallDistance {
  double value = 0;
  double nx = 0, ny = 0;
};

/// What lies behind a straight wall.
struct HalfPlane {
  Point at{};
  double nx = 0, ny = 1;  ///< into the fluid

  WallDistance distance(double x, double y) const { return {(x - at[0]) * nx + (y - at[1]) * ny, nx, ny}; }
};

/// What lies behind two straight walls that meet in a corner around which the fluid turns: the part that two
/// half planes have in common. Both stand at the corner; who follows the wall with the fluid on the left
/// comes along `before` and goes on along `after`.
struct Wedge {
  HalfPlane before, after;

  WallDistance distance(double x, double y) const {
    const double dx = x - before.at[0], dy = y - before.at[1];
    // The walls lead away from the corner along the normals turned by 90 degrees: one to the left, one to
    // the right.
    const bool beside_before = dy * before.nx - dx * before.ny >= 0;
    const bool beside_after = dx * after.ny - dy * after.nx >= 0;
    const WallDistance to_before = before.distance(x, y), to_after = after.distance(x, y);
    if (to_before.value >= 0 && beside_before) return to_before;
    if (to_after.value >= 0 && beside_after) return to_after;
    if (to_before.value <= 0 && to_after.value <= 0) {
      return to_before.value > to_after.value ? to_before : to_after;
    }
    const double r = std::sqrt(dx * dx + dy * dy);
    return {r, dx / r, dy / r};
  }
};

/// What lies behind a semicircle and the wall it stands on: the whole disc, its other half is behind the
/// wall. With `period` above 0 it repeats along x. Takes its distance if that is less than the nearest so
/// far; most thrombi are far away, which is seen without a root.
inline void take_if_nearer(const Bump& bump, double period, double x, double y, WallDistance& nearest) {
  double dx = x - bump.centre[0];
  if (period > 0) dx -= period * std::round(dx / period);
  const double dy = y - bump.centre[1];
  const double r2 = dx * dx + dy * dy;
  const double reach = nearest.value + bump.radius;
  if (reach <= 0 || r2 >= reach * reach) return;
  const double r = std::sqrt(r2);
  // In the very centre every way out is as long.
  nearest = r > 0 ? WallDistance{r - bump.radius, dx / r, dy / r} : WallDistance{-bump.radius, 0, 1};
}

}  // namespace rouleau::geometry
