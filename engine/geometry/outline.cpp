#include "engine/geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rouleau::geometry {

WallDistance Outline::distance(double x, double y) const {
  WallDistance nearest{std::numeric_limits<double>::infinity(), 0, 0};
  const auto take = [&](const WallDistance& distance) {
    if (distance.value < nearest.value) nearest = distance;
  };
  for (const HalfPlane& plane : vessel_.planes) take(plane.distance(x, y));
  for (const Wedge& wedge : vessel_.wedges) take(wedge.distance(x, y));
  for (const Bump& bump : vessel_.bumps) take_if_nearer(bump, vessel_.period_x, x, y, nearest);
  return nearest;
}

bool Outline::contains(double x, double y) const {
  const auto passed = [&](const Opening& opening) {
    const double across = opening.across(x, y);
    return opening.beyond(x, y) > 0 && across >= 0 && across <= opening.width;
  };
  return distance(x, y).value >= 0 && std::none_of(inlets().begin(), inlets().end(), passed) &&
         std::none_of(outlets().begin(), outlets().end(), passed);
}

std::vector<WallNode> Outline::wall_nodes(double spacing, double extension) const {
  std::vector<WallNode> nodes;
  for (const WallChain& chain : vessel_.chains) add_nodes(chain, spacing, extension, nodes);
  const double rounding = 1e-6 * spacing;
  for (WallNode& node : nodes) {
    for (const Opening& inlet : inlets()) node.beyond_inlet |= inlet.beyond(node.x, node.y) > rounding;
    if (vessel_.period_x > 0) node.x -= vessel_.period_x * std::floor((node.x + rounding) / vessel_.period_x);
  }
  return nodes;
}

}  // namespace rouleau::geometry
