#pragma once

#include "engine/effects/state.h"

namespace rouleau::observe {

/// Puts a cell's nodes elsewhere, evenly along t from 0 to 1: to place(t), in own units. What surrounds them
/// stays where it is.
template <class Place>
void put_nodes(effects::State& state, std::size_t k, const Place& place) {
  const effects::CellState& cell = state.cells[k];
  for (int q = 0; q < cell.nodes; ++q) {
    const auto [x, y] = place(static_cast<double>(q) / cell.nodes);
    state.particles.x[cell.first_node + q] = x;
    state.particles.y[cell.first_node + q] = y;
  }
}

/// Gives everything that has a velocity that of a field, in own units.
template <class Velocity>
void set_velocity(effects::State& state, const Velocity& velocity) {
  auto& particles = state.particles;
  for (int i = 0; i < particles.velocity_end(); ++i) {
    const auto [u, v] = velocity(particles.x[i], particles.y[i]);
    particles.u[i] = u;
    particles.v[i] = v;
  }
}

}  // namespace rouleau::observe
