#pragma once

#include "engine/case/case.h"

namespace rouleau {

/// The simulation's own units: the vessel, its flow and the plasma density are 1, so a scene
/// a thousand times smaller gives the same numbers. Multiply by a scale to get SI.
struct Scales {
  double length = 1;    ///< m
  double velocity = 1;  ///< m/s
  double density = 1;   ///< kg/m3

  double time() const { return length / velocity; }                         ///< s
  double pressure() const { return density * velocity * velocity; }         ///< Pa
  double acceleration() const { return velocity * velocity / length; }      ///< m/s2
  double tension() const { return pressure() * length; }                    ///< N/m, force per unit depth
  double bending() const { return pressure() * length * length * length; }  ///< J, bending modulus
  double flux() const { return velocity * length; }                         ///< m2/s per unit depth
  double viscosity() const { return velocity * length; }                    ///< m2/s
};

/// Length: the vessel's diameter (the trunk's, a box's height). Velocity: the inflow's; without one that of
/// the fastest wall, of the vortices, or the one to which the body's acceleration leads; nu over the length
/// where nothing drives the plasma.
Scales scales_of(const Case& scene);

}  // namespace rouleau
