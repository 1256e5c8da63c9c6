#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cells/link.h"
#include "engine/cells/shape.h"

namespace rouleau::cells {

bool contains(Ring ring, double px, double py) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    if ((ring.y[i] > py) == (ring.y[j] > py)) continue;
    const double fraction = (py - ring.y[i]) / (ring.y[j] - ring.y[i]);
    if (px < ring.x[i] + fraction * (ring.x[j] - ring.x[i])) inside = !inside;
  }
  return inside;
}

Nearest nearest(Ring ring, double px, double py) {
  double best = std::numeric_limits<double>::infinity(), best_s = 0.0;
  std::size_t best_link = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    const double dx = ring.x[j] - ring.x[i], dy = ring.y[j] - ring.y[i];
    const double rx = px - ring.x[i], ry = py - ring.y[i];
    const double length2 = dx * dx + dy * dy;
    if (length2 == 0.0) continue;  // its neighbours hold the point, and have a normal
    const double s = std::clamp((rx * dx + ry * dy) / length2, 0.0, 1.0);
    const double ox = rx - s * dx, oy = ry - s * dy;
    const double distance2 = ox * ox + oy * oy;
    if (distance2 < best) {
      best = distance2;
      best_s = s;
      best_link = i;
    }
  }
  const Link link = link_at(ring, best_link);
  const double along = best_s * link.length;
  return {static_cast<int>(best_link),         best_s,  std::sqrt(best), ring.x[best_link] + along * link.ex,
          ring.y[best_link] + along * link.ey, link.ey, -link.ex};
}

}  // namespace rouleau::cells
