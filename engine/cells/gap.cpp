#include "engine/cells/gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rouleau::cells {

namespace {

double distance_to_link(Ring ring, std::size_t link, double px, double py) {
  const std::size_t to = ring.next(link);
  const double ex = ring.x[to] - ring.x[link], ey = ring.y[to] - ring.y[link];
  const double dx = px - ring.x[link], dy = py - ring.y[link];
  const double length2 = ex * ex + ey * ey;
  const double s = length2 > 0 ? std::clamp((dx * ex + dy * ey) / length2, 0.0, 1.0) : 0;
  return std::hypot(dx - s * ex, dy - s * ey);
}

std::optional<Crossing> crossing_of(Ring a, std::size_t i, Ring b, std::size_t j) {
  const std::size_t i1 = a.next(i), j1 = b.next(j);
  const double ax = a.x[i1] - a.x[i], ay = a.y[i1] - a.y[i];
  const double bx = b.x[j1] - b.x[j], by = b.y[j1] - b.y[j];
  const double dx = b.x[j] - a.x[i], dy = b.y[j] - a.y[i];
  const double cross = ax * by - ay * bx;
  if (cross == 0) return std::nullopt;
  const double s = (dx * by - dy * bx) / cross, t = (dx * ay - dy * ax) / cross;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return Crossing{i, j, a.x[i] + s * ax, a.y[i] + s * ay};
}

}  // namespace

double least_gap(const LinkBoxes& a, const LinkBoxes& b) {
  const Ring ring_a = a.ring(), ring_b = b.ring();
  // Any pair bounds the search.
  double least = std::hypot(ring_a.x[0] - ring_b.x[0], ring_a.y[0] - ring_b.y[0]);
  LinkBoxes::visit_near(a, b, least, [&](std::size_t i, std::size_t j) {
    least = std::min({least, distance_to_link(ring_b, j, ring_a.x[i], ring_a.y[i]),
                      distance_to_link(ring_a, i, ring_b.x[j], ring_b.y[j])});
  });
  return least;
}

double wall_gap(Ring ring, const geometry::Outline& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, outline.distance(ring.x[i], ring.y[i]).value);
  }
  const auto take = [&](const geometry::Point& centre, double radius) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // A ring that is deep in the wall is so by its nodes.
      least = std::min(least, std::max(0.0, distance_to_link(ring, i, centre[0], centre[1]) - radius));
    }
  };
  for (const geometry::Wedge& wedge : outline.wedges()) take(wedge.before.at, 0);
  for (const geometry::Bump& bump : outline.bumps()) {
    take(bump.centre, bump.radius);
    outline.visit_images([&](double dx, double dy) {
      take({bump.centre[0] + dx, bump.centre[1] + dy}, bump.radius);
    });
  }
  return least;
}

std::optional<Crossing> find_crossing(const LinkBoxes& a, const LinkBoxes& b) {
  std::optional<Crossing> found;
  LinkBoxes::visit_near(a, b, 0, [&](std::size_t i, std::size_t j) {
    if (!found) found = crossing_of(a.ring(), i, b.ring(), j);
  });
  return found;
}

std::optional<Crossing> find_crossing(const LinkBoxes& boxes) {
  const Ring ring = boxes.ring();
  std::optional<Crossing> found;
  LinkBoxes::visit_near(boxes, boxes, 0, [&](std::size_t i, std::size_t j) {
    if (found || j <= i || j == ring.next(i) || i == ring.next(j)) return;
    found = crossing_of(ring, i, ring, j);
  });
  return found;
}

}  // namespace rouleau::cells
