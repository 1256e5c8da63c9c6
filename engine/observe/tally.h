#pragma once

#include "engine/observe/flow_planes.h"
#include "engine/observe/observer.h"

namespace rouleau::observe {

/// Keeps what a summary needs: extremes of the cells, flow through the openings, eq. 22 where it applies.
class Tally : public Observer {
 public:
  explicit Tally(const effects::State& state);

  void follow(const effects::State& state) override;
  /// Into the summary's members that are the tally's.
  void report(RunSummary& summary) const override;

  void save(ByteWriter& bytes) override { bytes(*this); }
  void restore(ByteReader& bytes) override { bytes(*this); }
  template <class Stream>
  friend void visit(Stream& stream, Tally& tally) {
    const std::size_t cells = tally.cells_.size();
    stream(tally.cells_, tally.volume_in_, tally.volume_out_, tally.volume_through_, tally.deviation_sum_,
           tally.deviation_worst_, tally.deviation_samples_);
    tally.cells_.resize(cells);
  }

 private:
  void add_membrane(const effects::State& state, std::size_t k);
  void add_flow(const effects::State& state);

  std::vector<CellSummary> cells_;
  FlowPlanes planes_;
  bool has_openings_;
  bool develops_;
  double volume_in_ = 0, volume_out_ = 0;
  double volume_through_ = 0;  ///< the inlet, either way
  double deviation_sum_ = 0, deviation_worst_ = 0;
  long deviation_samples_ = 0;
};

extern const ObserverKind run_summary;

}  // namespace rouleau::observe
