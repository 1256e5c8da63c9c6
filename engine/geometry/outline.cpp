#include "engine/geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rouleau::geometry {

namespace {

/// Nodes between x0 and x1, both left out.
void add_between(double x0, double x1, double y, double normal, double spacing,
                 std::vector<WallNode>& nodes) {
  const int pieces = static_cast<int>(std::lround((x1 - x0) / spacing));
  for (int k = 1; k < pieces; ++k) nodes.push_back({x0 + (x1 - x0) * k / pieces, y, 0, normal});
}

/// From the arc's upstream foot to its downstream foot; both feet are corners.
void add_arc(const Bump& bump, double normal, double spacing, std::vector<WallNode>& nodes) {
  const int pieces = std::max(2, static_cast<int>(std::lround(std::numbers::pi * bump.radius / spacing)));
  const double diagonal = std::numbers::sqrt2 / 2;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(k) / pieces);
    WallNode node{bump.x + bump.radius * std::cos(angle), bump.y + normal * bump.radius * std::sin(angle),
                  std::cos(angle), normal * std::sin(angle)};
    if (k == 0 || k == pieces) {
      node.y = bump.y;
      node.nx = k == 0 ? -diagonal : diagonal;
      node.ny = normal * diagonal;
    }
    nodes.push_back(node);
  }
}

}  // namespace

Outline::Outline(double length, double height, std::vector<Bump> bumps)
    : length_(length), height_(height), bumps_(std::move(bumps)) {
  std::sort(bumps_.begin(), bumps_.end(), [](const Bump& a, const Bump& b) { return a.x < b.x; });
}

WallDistance Outline::distance(double x, double y) const {
  WallDistance nearest{y, 0, 1};
  if (height_ - y < nearest.value) nearest = {height_ - y, 0, -1};
  for (const Bump& bump : bumps_) {
    const double dx = x - bump.x;
    const double dy = y - bump.y;
    const double r = std::hypot(dx, dy);
    if (r - bump.radius < nearest.value && r > 0) nearest = {r - bump.radius, dx / r, dy / r};
  }
  return nearest;
}

double Outline::narrowest() const {
  double least = height_;
  for (const Bump& a : bumps_) {
    least = std::min(least, height_ - a.radius);
    for (const Bump& b : bumps_) {
      if (a.y != b.y) least = std::min(least, std::hypot(a.x - b.x, height_) - a.radius - b.radius);
    }
  }
  return least;
}

void Outline::add_wall(double y, double normal, double spacing, double extension,
                       std::vector<WallNode>& nodes) const {
  double x = -extension;
  nodes.push_back({x, y, 0, normal});
  for (const Bump& bump : bumps_) {
    if (bump.y != y) continue;
    const double foot = bump.x - bump.radius;
    add_between(x, foot, y, normal, spacing, nodes);
    if (foot - x < 1e-6 * spacing) nodes.pop_back();  // two arcs share a foot
    add_arc(bump, normal, spacing, nodes);
    x = bump.x + bump.radius;
  }
  add_between(x, length_ + extension, y, normal, spacing, nodes);
  nodes.push_back({length_ + extension, y, 0, normal});
}

std::vector<WallNode> Outline::wall_nodes(double spacing, double extension) const {
  std::vector<WallNode> nodes;
  add_wall(0, 1, spacing, extension, nodes);
  add_wall(height_, -1, spacing, extension, nodes);
  return nodes;
}

}  // namespace rouleau::geometry
