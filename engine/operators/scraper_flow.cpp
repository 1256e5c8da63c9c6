#include "engine/operators/scraper_flow.h"

#include <cmath>
#include <numbers>

namespace rouleau::operators {

namespace {

// Stream function r (A sin t + B t cos t + C t sin t), t the angle from the wall that moves.
constexpr double pi = std::numbers::pi;
constexpr double B = 4 / (4 - pi * pi), C = B * pi / 2, A = 1 - B;

/// Radial and circumferential velocity and the pressure, for a wall that moves away from the corner at
/// speed 1.
struct Polar {
  double radial, around, pressure;
};

Polar scraper(double r, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {(A + B + C * angle) * c + (C - B * angle) * s, -((A + C * angle) * s + B * angle * c),
          2 * (B * c + C * s) / r};
}

bool turns_left(const geometry::WallPiece& before, const geometry::WallPiece& after) {
  const double ax = before.to[0] - before.from[0], ay = before.to[1] - before.from[1];
  const double bx = after.to[0] - after.from[0], by = after.to[1] - after.from[1];
  const double lengths = std::hypot(ax, ay) * std::hypot(bx, by);
  return std::abs(ax * bx + ay * by) < 1e-9 * lengths && ax * by - ay * bx > 0;
}

}  // namespace

ScraperFlow::ScraperFlow(const std::vector<geometry::WallChain>& walls) {
  for (const geometry::WallChain& chain : walls) {
    const std::size_t n = chain.pieces.size();
    for (std::size_t k = chain.loop ? 0 : 1; k < n; ++k) {
      const geometry::WallPiece &before = chain.pieces[(k + n - 1) % n], &after = chain.pieces[k];
      if (before.radius > 0 || after.radius > 0 || (before.speed == 0 && after.speed == 0)) continue;
      if (!turns_left(before, after)) continue;
      const double tx = after.to[0] - after.from[0], ty = after.to[1] - after.from[1];
      const double length = std::hypot(tx, ty);
      corners_.push_back({after.from, tx / length, ty / length, after.speed, -before.speed});
    }
  }
}

KnownFlow ScraperFlow::at(double x, double y) const {
  KnownFlow flow;
  for (const Corner& corner : corners_) {
    const double dx = x - corner.at[0], dy = y - corner.at[1];
    const double along = dx * corner.tx + dy * corner.ty, aside = dy * corner.tx - dx * corner.ty;
    const double r = std::hypot(along, aside);
    if (r == 0) continue;
    const double angle = std::atan2(aside, along);
    const Polar leaving = scraper(r, angle), arriving = scraper(r, pi / 2 - angle);
    const double radial = corner.leaving * leaving.radial + corner.arriving * arriving.radial;
    const double around = corner.leaving * leaving.around - corner.arriving * arriving.around;
    const double cx = (radial * along - around * aside) / r, cy = (radial * aside + around * along) / r;
    flow.u += cx * corner.tx - cy * corner.ty;
    flow.v += cx * corner.ty + cy * corner.tx;
    flow.p += corner.leaving * leaving.pressure + corner.arriving * arriving.pressure;
  }
  return flow;
}

}  // namespace rouleau::operators
