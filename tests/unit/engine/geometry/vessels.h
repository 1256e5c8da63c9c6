#pragma once

#include <cmath>
#include <vector>

#include "engine/geometry/outline.h"

namespace rouleau::geometry {

/// Scenes whose SI lengths and velocities are the outline's.

inline Case straight_vessel(double length, double height, std::vector<Thrombus> thrombi = {}) {
  Case scene;
  scene.vessel.length = length;
  scene.vessel.diameter = height;
  scene.thrombi = std::move(thrombi);
  return scene;
}

/// The study's: trunk 4 by 1, branches 2 by 0.5 at 30 degrees; the apex lies in x = 4.1340, y = 0.5.
inline Case bifurcation(std::vector<Thrombus> thrombi = {}) {
  Case scene = straight_vessel(4, 1, std::move(thrombi));
  scene.vessel.shape = Shape::bifurcation;
  scene.vessel.branches = {{{2, 0.5}, {2, 0.5}}};
  return scene;
}

/// Branches that differ, at an angle of their own, with a thrombus on every outer wall.
inline Case uneven_bifurcation() {
  Case scene = bifurcation(
      {{Wall::lower, 1.1, 0.3}, {Wall::upper, 2.3, 0.25}, {Wall::lower, 4.9, 0.15}, {Wall::upper, 5.1, 0.2}});
  scene.vessel.branches = {{{1.7, 0.4}, {2.3, 0.55}}};
  scene.vessel.half_angle = 38;
  return scene;
}

inline Case box(double width, double height, Ends ends) {
  Case scene = straight_vessel(width, height);
  scene.vessel.shape = Shape::box;
  scene.vessel.ends = ends;
  return scene;
}

inline Outline outline_of(const Case& scene) {
  return {scene, 1, 1};
}

inline double wall_length(const Outline& outline) {
  double sum = 0;
  for (const WallChain& chain : outline.walls()) {
    for (const WallPiece& piece : chain.pieces) {
      sum += piece.radius > 0 ? 3.14159265358979323846 * piece.radius
                              : std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
    }
  }
  return sum;
}

}  // namespace rouleau::geometry
