#pragma once

#include "engine/effects/state.h"
#include "engine/simulation/run.h"

namespace rouleau::observe {

/// Keeps what a summary needs: extremes of the cells, flow through both ends, eq. 22 where it applies.
class Tally {
 public:
  explicit Tally(const effects::State& state);

  /// After every step.
  void add(const effects::State& state);
  /// Into the summary's members that are the tally's.
  void report(RunSummary& summary) const;

 private:
  void add_flow(const effects::State& state);

  std::vector<CellSummary> cells_;
  bool plain_vessel_;
  double volume_in_ = 0, volume_out_ = 0;
  double deviation_sum_ = 0, deviation_worst_ = 0;
  long deviation_samples_ = 0;
};

}  // namespace rouleau::observe
