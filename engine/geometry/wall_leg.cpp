#include "engine/geometry/wall_leg.h"

#include <cmath>

namespace rouleau::geometry {

namespace {

double span_of(const WallLeg& leg) {
  return std::hypot(leg.to[0] - leg.from[0], leg.to[1] - leg.from[1]);
}

Point direction_of(const WallLeg& leg) {
  const double span = span_of(leg);
  return {(leg.to[0] - leg.from[0]) / span, (leg.to[1] - leg.from[1]) / span};
}

double foot_of(const WallLeg& leg, const Bump& bump) {
  return std::hypot(bump.centre[0] - leg.from[0], bump.centre[1] - leg.from[1]) - bump.radius;
}

/// From `start` to `end` along the leg. Between arcs that touch there is no straight piece.
void add_pieces(const WallLeg& leg, double start, double end, std::vector<WallPiece>& pieces) {
  const Point direction = direction_of(leg);
  const auto along = [&](double s) {
    return Point{leg.from[0] + s * direction[0], leg.from[1] + s * direction[1]};
  };
  double reached = start;
  const auto go_straight = [&](double to) {
    if (to - reached > 1e-9 * (end - start)) {
      pieces.push_back({along(reached), along(to), 0, {}, leg.speed});
    }
  };
  for (const Bump& bump : leg.bumps) {
    const double foot = foot_of(leg, bump);
    go_straight(foot);
    reached = foot + 2 * bump.radius;
    pieces.push_back({along(foot), along(reached), bump.radius, bump.centre, leg.speed});
  }
  go_straight(end);
}

}  // namespace

HalfPlane behind(const WallLeg& leg) {
  const Point direction = direction_of(leg);
  return {leg.from, -direction[1], direction[0]};
}

WallChain chain_of(const std::vector<WallLeg>& legs, bool loop) {
  WallChain chain{{}, loop};
  for (const WallLeg& leg : legs) add_pieces(leg, 0, span_of(leg), chain.pieces);
  return chain;
}

WallChain periodic_chain(const WallLeg& leg) {
  WallChain chain{{}, true};
  const double start = leg.bumps.empty() ? 0 : foot_of(leg, leg.bumps.front());
  add_pieces(leg, start, start + span_of(leg), chain.pieces);
  return chain;
}

}  // namespace rouleau::geometry
