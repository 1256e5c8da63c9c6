#pragma once

#include <vector>

namespace rouleau::geometry {

/// A semicircle that stands on a wall, its centre on the wall.
struct Bump {
  double x = 0, y = 0;  ///< of its centre; y is 0 or the height of the vessel
  double radius = 0;
};

/// A node on the true wall surface.
struct WallNode {
  double x = 0, y = 0;
  double nx = 0, ny = 0;  ///< unit normal into the fluid (at a corner the bisector)
};

/// Distance to the nearest wall: positive in the fluid, with the unit normal that leads away from the wall.
struct WallDistance {
  double value = 0;
  double nx = 0, ny = 0;
};

/// The fluid's outline: a straight vessel 0 < y < height with semicircles on its walls, an inlet plane at
/// x = 0 and an outlet plane at x = length. The walls go on straight beyond both planes.
class Outline {
 public:
  Outline(double length, double height, std::vector<Bump> bumps);

  double length() const { return length_; }
  double height() const { return height_; }
  const std::vector<Bump>& bumps() const { return bumps_; }

  /// Exact signed distance in the fluid and near its walls.
  WallDistance distance(double x, double y) const;

  /// The least width left between opposite walls (and what stands on them).
  double narrowest() const;

  /// Nodes on both walls, evenly spaced by about `spacing` on each straight piece and each arc, with a node
  /// in every corner, reaching `extension` beyond inlet and outlet.
  std::vector<WallNode> wall_nodes(double spacing, double extension) const;

 private:
  void add_wall(double y, double normal, double spacing, double extension,
                std::vector<WallNode>& nodes) const;

  double length_;
  double height_;
  std::vector<Bump> bumps_;
};

}  // namespace rouleau::geometry
