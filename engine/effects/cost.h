#pragma once

#include "engine/case/case.h"

namespace rouleau::effects {

/// What there is to do in a scene, as far as it is known before it runs.
struct Work {
  const Case& scene;
  double particles = 0;  ///< that move, membranes included
  double membrane_nodes = 0;
  double wall_nodes = 0;
  double inlet_rows = 0;   ///< of particles across the inlet; 0: there is none
  double outlet_rows = 0;  ///< across all outlets together
  double along = 0;        ///< spacings from the inlet to an outlet, or along the vessel
  double gap = 0;          ///< the narrowest place, in spacings
  double spacing = 0;      ///< m
  double diffusion = 0;    ///< nu dt / d0^2 of the planned step
  double stiffness =
      0;  ///< E_s dt^2 / (rho d0^3) of the stiffest membrane: how far a step overshoots its rest
};

/// What an effect or observer takes, each time that it is applied, in ns on the machine that docs/plan.md
/// names. A plan sums these: whatever an effect leaves out counts for nothing.
struct Cost {
  double once = 0;  ///< however small the scene is
  double particle = 0;
  double membrane_node = 0;
  double wall_node = 0;
  double each = 0;                         ///< for each of what `count` counts
  double (*count)(const Work&) = nullptr;  ///< particles times iterations of a solver, points of probes, ...
};

inline double cost_of(const Cost& cost, const Work& work) {
  return cost.once + cost.particle * work.particles + cost.membrane_node * work.membrane_nodes +
         cost.wall_node * work.wall_nodes + (cost.count != nullptr ? cost.each * cost.count(work) : 0);
}

}  // namespace rouleau::effects
