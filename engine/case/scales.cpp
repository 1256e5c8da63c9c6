#include "engine/case/scales.h"

#include <algorithm>
#include <cmath>

namespace rouleau {

namespace {

double fastest_wall(const WallVelocity& walls) {
  return std::max(
      {std::abs(walls.lower), std::abs(walls.upper), std::abs(walls.left), std::abs(walls.right)});
}

/// Of the developed flow between two walls, or of free fall over the length if that is slower.
double driven_velocity(const Case& scene) {
  const double acceleration = std::hypot(scene.body_acceleration[0], scene.body_acceleration[1]);
  const double length = scene.vessel.diameter;
  return std::min(std::sqrt(acceleration * length),
                  acceleration * length * length / (12 * scene.plasma.kinematic_viscosity));
}

double velocity_of(const Case& scene) {
  if (is_open(scene.vessel)) return scene.inflow.velocity;
  const double driven =
      std::max({fastest_wall(scene.vessel.wall_velocity), driven_velocity(scene), scene.initial.velocity});
  return driven > 0 ? driven : scene.plasma.kinematic_viscosity / scene.vessel.diameter;
}

}  // namespace

Scales scales_of(const Case& scene) {
  return {scene.vessel.diameter, velocity_of(scene), scene.plasma.density};
}

}  // namespace rouleau
