#pragma once

#include <array>
#include <vector>

namespace rouleau::geometry {

using Point = std::array<double, 2>;

/// A semicircle that stands on a wall, its centre on the wall.
struct Bump {
  Point centre{};
  double radius = 0;
};

/// A straight piece of wall, or a semicircle that bulges into the fluid; run through with the fluid on its
/// left.
struct WallPiece {
  Point from{}, to{};
  double radius = 0;  ///< of the arc, 0: straight
  Point centre{};     ///< of the arc
  double speed = 0;   ///< of the wall along itself, from -> to
};

/// Pieces of wall, each going on where the last one ends.
struct WallChain {
  std::vector<WallPiece> pieces;
  bool loop = false;  ///< the last piece meets the first (or its next image in a periodic vessel); else the
                      ///< wall goes on straight beyond both ends
};

/// A plane that plasma crosses: the segment from `corner` over `width` along (tx, ty), and the unit vector
/// (ax, ay) out of the vessel. (tx, ty) is (ax, ay) turned by 90 degrees counter-clockwise for an outlet; at
/// the inlet it points up, as the vessel's y does.
struct Opening {
  Point corner{};
  double tx = 0, ty = 1;
  double ax = 1, ay = 0;
  double width = 0;

  /// How far a point is beyond the plane, out of the vessel.
  double beyond(double x, double y) const { return (x - corner[0]) * ax + (y - corner[1]) * ay; }
  /// Where along the plane it is, from 0 to the width.
  double across(double x, double y) const { return (x - corner[0]) * tx + (y - corner[1]) * ty; }
  /// The point at these two.
  Point at(double across, double beyond) const {
    return {corner[0] + across * tx + beyond * ax, corner[1] + across * ty + beyond * ay};
  }
};

struct Bounds {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

}  // namespace rouleau::geometry
