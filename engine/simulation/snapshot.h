#pragma once

#include "engine/effects/state.h"

namespace rouleau {

/// What a state keeps from one step to the next, so that a step can be taken again.
class Snapshot {
 public:
  void take(const effects::State& state);
  void restore(effects::State& state) const;

 private:
  particles::ParticleSet particles_;
  std::vector<effects::CellState> cells_;
  std::vector<effects::Lane> lanes_;
  std::vector<double> pressure_gx_, pressure_gy_;
  effects::Counters counters_;
  double speed_ = 0;
};

}  // namespace rouleau
