#include "engine/geometry/wall_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rouleau::geometry {

namespace {

/// The wall at one of its points.
struct Place {
  Point at{};
  Point tangent{};  ///< along the piece; the normal into the fluid is on its left
};

double length_of(const WallPiece& piece) {
  if (piece.radius > 0) return std::numbers::pi * piece.radius;
  return std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
}

int steps_of(const WallPiece& piece, double spacing) {
  return std::max(piece.radius > 0 ? 2 : 1, static_cast<int>(std::lround(length_of(piece) / spacing)));
}

/// Point `step` of `steps` from the beginning of the piece. Arcs run clockwise.
Place place_on(const WallPiece& piece, int step, int steps) {
  const double dx = piece.to[0] - piece.from[0], dy = piece.to[1] - piece.from[1];
  const double span = std::hypot(dx, dy);
  const double tx = dx / span, ty = dy / span;
  if (piece.radius == 0) {
    return {{piece.from[0] + dx * step / steps, piece.from[1] + dy * step / steps}, {tx, ty}};
  }
  const double angle = std::numbers::pi * step / steps;
  const double c = std::cos(angle), s = std::sin(angle);
  const double nx = -tx * c - ty * s, ny = -ty * c + tx * s;
  Point at{piece.centre[0] + piece.radius * nx, piece.centre[1] + piece.radius * ny};
  if (step == 0) at = piece.from;
  if (step == steps) at = piece.to;
  return {at, {ny, -nx}};
}

WallNode node_at(const Place& place, double speed) {
  const auto [tx, ty] = place.tangent;
  return {place.at[0], place.at[1], -ty, tx, speed * tx, speed * ty};
}

/// Where two pieces meet: `end` of the one, `begin` of the next. Where the walls disagree on the velocity, as
/// in the corners of a lid-driven cavity, the stress is singular and no velocity is right.
WallNode corner_of(const WallNode& end, const WallNode& begin) {
  WallNode node = begin;
  double nx = end.nx + begin.nx, ny = end.ny + begin.ny;
  // Between two arcs that touch the fluid narrows to a cusp; there the way on less the way back leads out.
  if (std::hypot(nx, ny) < 1e-6) {
    nx = begin.ny - end.ny;
    ny = end.nx - begin.nx;
  }
  const double norm = std::hypot(nx, ny);
  node.nx = nx / norm;
  node.ny = ny / norm;
  const double difference = std::hypot(end.u - begin.u, end.v - begin.v);
  node.torn = difference > 1e-9 * (std::hypot(end.u, end.v) + std::hypot(begin.u, begin.v));
  if (node.torn) node.u = node.v = 0;
  return node;
}

void draw_out(WallPiece& first, WallPiece& last, double extension) {
  const Place begin = place_on(first, 0, 1), end = place_on(last, 1, 1);
  for (int k = 0; k < 2; ++k) {
    first.from[k] -= extension * begin.tangent[k];
    last.to[k] += extension * end.tangent[k];
  }
}

}  // namespace

void add_nodes(const WallChain& chain, double spacing, double extension, std::vector<WallNode>& nodes) {
  std::vector<WallPiece> pieces = chain.pieces;
  if (!chain.loop) draw_out(pieces.front(), pieces.back(), extension);
  const auto end_of = [&](const WallPiece& piece) {
    const int steps = steps_of(piece, spacing);
    WallNode node = node_at(place_on(piece, steps, steps), piece.speed);
    node.length = length_of(piece) / steps / 2;
    return node;
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const int steps = steps_of(pieces[k], spacing);
    const double step_length = length_of(pieces[k]) / steps;
    for (int step = 0; step < steps; ++step) {
      WallNode node = node_at(place_on(pieces[k], step, steps), pieces[k].speed);
      node.length = step_length;
      if (step == 0) {
        node.length = step_length / 2;
        if (k > 0 || chain.loop) {
          const WallNode before = end_of(k > 0 ? pieces[k - 1] : pieces.back());
          node = corner_of(before, node);
          node.length += before.length;
        }
      }
      nodes.push_back(node);
    }
  }
  if (!chain.loop) nodes.push_back(end_of(pieces.back()));
}

}  // namespace rouleau::geometry
