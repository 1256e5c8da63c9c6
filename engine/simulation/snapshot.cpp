#include "engine/simulation/snapshot.h"

namespace rouleau {

void Snapshot::take(const effects::State& state) {
  particles_ = state.particles;
  cells_ = state.cells;
  lanes_ = state.lanes;
  pressure_gx_ = state.pressure_gx;
  pressure_gy_ = state.pressure_gy;
  counters_ = state.counters;
  speed_ = state.speed;
}

void Snapshot::restore(effects::State& state) const {
  state.particles = particles_;
  state.cells = cells_;
  state.lanes = lanes_;
  state.pressure_gx = pressure_gx_;
  state.pressure_gy = pressure_gy_;
  state.counters = counters_;
  state.speed = speed_;
}

}  // namespace rouleau
