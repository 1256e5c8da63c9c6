#pragma once

#include <vector>

#include "engine/case/case.h"
#include "engine/geometry/shapes.h"
#include "engine/geometry/vessel_walls.h"
#include "engine/geometry/wall_distance.h"
#include "engine/geometry/wall_nodes.h"

namespace rouleau::geometry {

/// The fluid's outline: walls as chains of straight pieces and arcs, the planes at its open ends, and the
/// directions in which it repeats. Walls go on straight beyond the planes.
class Outline {
 public:
  /// The vessel and its thrombi, which must be as `read_case` accepts them, in units of `unit_length` and
  /// `unit_velocity` (SI values of one unit).
  Outline(const Case& scene, double unit_length, double unit_velocity)
      : vessel_(walls_of(scene, unit_length, unit_velocity)) {}

  /// From inlet to outlets where the vessel is open. A periodic vessel's may reach past its end by what a
  /// thrombus leaves of the wall there.
  const std::vector<WallChain>& walls() const { return vessel_.chains; }
  /// The inlet, if the vessel is open; it lies in x = 0.
  const std::vector<Opening>& inlets() const { return vessel_.inlets; }
  /// The outlets: none, one, or of a bifurcation the lower and the upper one.
  const std::vector<Opening>& outlets() const { return vessel_.outlets; }
  const std::vector<Bump>& bumps() const { return vessel_.bumps; }

  double length() const { return vessel_.length; }  ///< of the vessel, of the trunk, or of the box along x
  double height() const { return vessel_.height; }  ///< its diameter, or of the box along y
  double period_x() const { return vessel_.period_x; }  ///< 0: not periodic
  double period_y() const { return vessel_.period_y; }
  /// Calls visit(dx, dy) with the displacement of each image that can be near to something in a periodic
  /// vessel: a period one way or the other, along one axis or both. Not at all where nothing repeats.
  template <class Visit>
  void visit_images(Visit visit) const {
    const int along_x = period_x() > 0 ? 1 : 0, along_y = period_y() > 0 ? 1 : 0;
    for (int a = -along_x; a <= along_x; ++a) {
      for (int b = -along_y; b <= along_y; ++b) {
        if (a != 0 || b != 0) visit(a * period_x(), b * period_y());
      }
    }
  }
  /// Of the fluid between the open ends, walls included.
  const Bounds& bounds() const { return vessel_.bounds; }
  /// Of the fluid between the open ends.
  double area() const { return vessel_.area; }
  /// The least width left between opposite walls and what stands on them; of a bifurcation the least of its
  /// three parts; where there are no walls the height.
  double narrowest() const { return vessel_.narrowest; }

  /// Exact distance in the fluid and behind a smooth wall; behind a corner into which the fluid reaches the
  /// depth below the wall that is left farther behind. The nearest image counts in a periodic vessel.
  /// Infinite where there are no walls.
  WallDistance distance(double x, double y) const;

  /// Calls visit(WallDistance) for each of the convex solids, whose union the walls are, that is nearer than
  /// `reach`: unlike the least of the distances, each has a continuous gradient in the fluid.
  template <class Visit>
  void visit_near(double x, double y, double reach, Visit visit) const {
    const auto visit_if_near = [&](const WallDistance& distance) {
      if (distance.value < reach) visit(distance);
    };
    for (const HalfPlane& plane : vessel_.planes) visit_if_near(plane.distance(x, y));
    for (const Wedge& wedge : vessel_.wedges) visit_if_near(wedge.distance(x, y));
    for (const Bump& bump : vessel_.bumps) {
      WallDistance distance{reach, 0, 0};
      take_if_nearer(bump, vessel_.period_x, x, y, distance);
      visit_if_near(distance);
    }
  }
  /// Corners around which the fluid turns.
  const std::vector<Wedge>& wedges() const { return vessel_.wedges; }

  /// Whether a point is in the fluid and between the open ends.
  bool contains(double x, double y) const;

  /// Nodes on all walls, evenly spaced by about `spacing` on each straight piece and each arc, with a node in
  /// every corner, reaching `extension` beyond the open ends. Chain by chain, in order along each.
  std::vector<WallNode> wall_nodes(double spacing, double extension) const;

  /// Points behind the walls, in `layers` layers a spacing apart below each of the nodes. Left out where the
  /// layers of one wall meet those of another or their own (behind the apex, within a thrombus): each point
  /// is at least half a spacing behind all walls and from the other points.
  std::vector<Point> ghosts(const std::vector<WallNode>& nodes, int layers, double spacing) const;

 private:
  VesselWalls vessel_;
};

}  // namespace rouleau::geometry
