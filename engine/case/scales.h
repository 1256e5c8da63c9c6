#pragma once

#include "engine/case/case.h"

namespace rouleau {

/// The simulation's own units: vessel diameter, mean inflow velocity and plasma density are 1, so a scene
/// a thousand times smaller gives the same numbers. Multiply by a scale to get SI.
struct Scales {
  double length = 1;    ///< m
  double velocity = 1;  ///< m/s
  double density = 1;   ///< kg/m3

  double time() const { return length / velocity; }                         ///< s
  double pressure() const { return density * velocity * velocity; }         ///< Pa
  double tension() const { return pressure() * length; }                    ///< N/m, force per unit depth
  double bending() const { return pressure() * length * length * length; }  ///< J, bending modulus
  double flux() const { return velocity * length; }                         ///< m2/s per unit depth
  double viscosity() const { return velocity * length; }                    ///< m2/s
};

inline Scales scales_of(const Case& scene) {
  return {scene.vessel.diameter, scene.inflow.velocity, scene.plasma.density};
}

}  // namespace rouleau
