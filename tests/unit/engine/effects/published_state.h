#pragma once

#include <cmath>

#include "engine/case/presets.h"
#include "engine/case/scales.h"
#include "engine/effects/effect.h"

namespace rouleau::effects {

/// A vessel in preset `paper`, ten spacings high: fluid on a square lattice, nodes on its walls, two rows of
/// ghosts behind them, and four columns each of inlet and outlet particles beyond its ends. At rest.
inline State published_state(bool with_outlet = true) {
  using particles::Group;
  Case scene;
  scene.vessel = {15e-6, 10e-6};
  scene.numerics = preset_numerics(Preset::paper);
  scene.numerics.spacing = 1e-6;
  State state(scene, scales_of(scene), 0.1);
  state.dt = 9 * state.projection.mps.largest_step(state.viscosity);  // of 12 sub-steps
  for (int a = -4; a < 19; ++a) {
    const double x = (a + 0.5) * state.spacing;
    const Group group = a < 0 ? Group::inlet : a >= 15 && with_outlet ? Group::outlet : Group::fluid;
    for (int b = 1; b < 10; ++b) state.particles.add(group, x, b * state.spacing);
    for (const int b : {0, 10}) state.particles.add(Group::wall, x, b * state.spacing);
    for (const int b : {-2, -1, 11, 12}) state.particles.add(Group::ghost, x, b * state.spacing);
  }
  sort_particles(state.particles, state.spacing);
  state.neighbours.build(state.particles);
  const auto active = static_cast<std::size_t>(state.particles.active_end());
  for (auto* field : {&state.ax, &state.ay, &state.source, &state.divergence}) field->assign(active, 0);
  return state;
}

/// Whether a place is three spacings or more from walls and ends, where the operators see the lattice alone.
inline bool deep_inside(const State& state, int i) {
  const double x = state.particles.x[i] / state.spacing, y = state.particles.y[i] / state.spacing;
  return x > 3 && x < 12 && y > 2.9 && y < 7.1;
}

inline void run(State& state, std::initializer_list<const EffectKind*> kinds) {
  for (const EffectKind* kind : kinds) kind->make(state)->apply(state);
}

}  // namespace rouleau::effects
