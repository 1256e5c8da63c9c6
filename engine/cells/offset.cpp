#include "engine/cells/offset.h"

#include <cmath>

namespace rouleau::cells {

void offset(Ring ring, double way, std::vector<double>& x, std::vector<double>& y) {
  x.assign(ring.x.begin(), ring.x.end());
  y.assign(ring.y.begin(), ring.y.end());
  for (std::size_t q = 0; q < ring.size(); ++q) {
    const std::size_t before = ring.previous(q), after = ring.next(q);
    const double tx = ring.x[after] - ring.x[before], ty = ring.y[after] - ring.y[before];
    const double length = std::hypot(tx, ty);
    x[q] += way * ty / length;
    y[q] -= way * tx / length;
  }
}

}  // namespace rouleau::cells
