#pragma once

#include <cmath>

#include "engine/case/scales.h"
#include "engine/effects/effect.h"
#include "engine/simulation/arrange.h"

namespace rouleau::effects {

/// The state in which the forces of a first step find a scene: placed, sorted, with its operators.
inline State prepared_state(const Case& scene) {
  const double across = std::round(scene.vessel.diameter / scene.numerics.spacing);
  State state(scene, scales_of(scene), 1 / across);
  state.dt = 0.1 * state.spacing;
  place_cells(state);
  place_fluid(state);
  place_walls(state);
  state.neighbours.sort(state.particles);
  state.neighbours.build(state.particles);
  state.operators.build(state.particles, state.neighbours);
  const auto active = static_cast<std::size_t>(state.particles.active_end());
  for (auto* field : {&state.ax, &state.ay, &state.source, &state.divergence}) field->assign(active, 0);
  const auto nodes = static_cast<std::size_t>(state.particles.membrane_end());
  state.load.fx.assign(nodes, 0);
  state.load.fy.assign(nodes, 0);
  return state;
}

}  // namespace rouleau::effects
