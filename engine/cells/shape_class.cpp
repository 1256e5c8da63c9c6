#include "engine/cells/shape_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/cells/shape.h"

namespace rouleau::cells {

namespace {

constexpr double least_depth = 0.02;        // over the radius of the disc of the same area
constexpr double comparable = 0.25;         // over the deepest
constexpr double greatest_asymmetry = 0.1;  // of a parachute
constexpr int scan_lines = 128;
const double half_right_angle = std::sqrt(0.5);

/// Indices of the corners of the convex hull, in the order of the ring (Andrew's monotone chain).
std::vector<std::size_t> hull_of(Ring ring) {
  std::vector<std::size_t> sorted(ring.size()), hull;
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::ranges::sort(sorted, [&](std::size_t a, std::size_t b) {
    return ring.x[a] != ring.x[b] ? ring.x[a] < ring.x[b] : ring.y[a] < ring.y[b];
  });
  const auto turns_left = [&](std::size_t a, std::size_t b, std::size_t c) {
    return (ring.x[b] - ring.x[a]) * (ring.y[c] - ring.y[a]) -
               (ring.y[b] - ring.y[a]) * (ring.x[c] - ring.x[a]) >
           0;
  };
  const auto extend = [&](std::size_t node, std::size_t base) {
    while (hull.size() >= base + 2 && !turns_left(hull[hull.size() - 2], hull.back(), node)) hull.pop_back();
    hull.push_back(node);
  };
  for (const std::size_t node : sorted) extend(node, 0);
  const std::size_t base = hull.size() - 1;
  for (auto node = sorted.rbegin() + 1; node != sorted.rend(); ++node) extend(*node, base);
  hull.pop_back();
  std::ranges::sort(hull);
  return hull;
}

using Interval = std::array<double, 2>;

/// What a line across the axis at `along` has within the ring, given as the nodes' coordinates along and
/// across the axis, by the even-odd rule.
std::vector<Interval> cut(const std::vector<std::array<double, 2>>& nodes, double along) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto &a = nodes[i], &b = nodes[i + 1 == nodes.size() ? 0 : i + 1];
    if ((a[0] > along) == (b[0] > along)) continue;
    crossings.push_back(a[1] + (along - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
  }
  std::ranges::sort(crossings);
  std::vector<Interval> intervals;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    intervals.push_back({crossings[k], crossings[k + 1]});
  }
  return intervals;
}

}  // namespace

std::string_view name_of(ShapeClass shape) {
  switch (shape) {
    case ShapeClass::biconcave:
      return "biconcave";
    case ShapeClass::parachute:
      return "parachute";
    case ShapeClass::slipper:
      return "slipper";
    case ShapeClass::folded:
      return "folded";
    case ShapeClass::other:
      break;
  }
  return "other";
}

std::vector<Concavity> concavities(Ring ring, double least) {
  std::vector<Concavity> found;
  const std::vector<std::size_t> hull = hull_of(ring);
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const std::size_t a = hull[k], b = hull[k + 1 == hull.size() ? 0 : k + 1];
    const double ex = ring.x[b] - ring.x[a], ey = ring.y[b] - ring.y[a];
    const double mouth = std::hypot(ex, ey);
    double depth = 0;
    for (std::size_t i = ring.next(a); i != b; i = ring.next(i)) {
      depth = std::max(depth, (ex * (ring.y[i] - ring.y[a]) - ey * (ring.x[i] - ring.x[a])) / mouth);
    }
    if (depth > least) found.push_back({depth, mouth, ey / mouth, -ex / mouth});
  }
  return found;
}

double asymmetry(Ring ring, std::array<double, 2> axis) {
  const Shape shape = measure(ring);
  const double length = std::hypot(axis[0], axis[1]);
  std::vector<std::array<double, 2>> nodes;
  double first = 1e300, last = -1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double dx = ring.x[i] - shape.x, dy = ring.y[i] - shape.y;
    nodes.push_back({(dx * axis[0] + dy * axis[1]) / length, (dy * axis[0] - dx * axis[1]) / length});
    first = std::min(first, nodes.back()[0]);
    last = std::max(last, nodes.back()[0]);
  }
  double covered = 0, shared = 0;
  for (int k = 0; k < scan_lines; ++k) {
    const auto intervals = cut(nodes, first + (last - first) * (k + 0.5) / scan_lines);
    for (const auto& [from, to] : intervals) {
      covered += to - from;
      for (const auto& [low, high] : intervals)
        shared += std::max(0.0, std::min(to, -low) - std::max(from, -high));
    }
  }
  return covered > 0 ? 1 - shared / covered : 0;
}

ShapeClass classify(Ring ring, std::array<double, 2> motion) {
  const double radius = std::sqrt(std::abs(area(ring)) / std::numbers::pi);
  std::vector<Concavity> found = concavities(ring, least_depth * radius);
  double deepest = 0;
  for (const Concavity& concavity : found) {
    if (concavity.depth > concavity.mouth) return ShapeClass::folded;
    deepest = std::max(deepest, concavity.depth);
  }
  std::erase_if(found, [&](const Concavity& concavity) { return concavity.depth < comparable * deepest; });
  if (found.size() == 2) {
    const double facing = found[0].nx * found[1].nx + found[0].ny * found[1].ny;
    return facing < -half_right_angle ? ShapeClass::biconcave : ShapeClass::other;
  }
  if (found.size() != 1) return ShapeClass::other;
  const double along =
      std::abs(found[0].nx * motion[0] + found[0].ny * motion[1]) / std::hypot(motion[0], motion[1]);
  const bool straight = along > half_right_angle && asymmetry(ring, motion) <= greatest_asymmetry;
  return straight ? ShapeClass::parachute : ShapeClass::slipper;
}

}  // namespace rouleau::cells
