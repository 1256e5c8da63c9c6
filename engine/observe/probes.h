#pragma once

#include <vector>

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// Samples the case's probes. What does not change is found once: which of their points lie in the fluid
/// and which parts of their lines the flux goes through.
class Probes : public Observer {
 public:
  explicit Probes(const effects::State& state);

  /// The probes as the header has them.
  std::vector<ProbeLine> lines() const;

  /// One entry a probe.
  std::vector<ProbeValues> values(const effects::State& state) const;

  void describe(Recorded& recorded) const override { recorded.probes = lines(); }
  void sample(const effects::State& state, Row& row) override { row.probes = values(state); }

 private:
  struct Line {
    std::string name;
    std::vector<std::array<double, 2>> points;
    std::vector<bool> inside;  ///< the fluid
    std::vector<operators::SamplingPlane> segments;
    bool is_point = false;
  };

  std::vector<Line> lines_;
  double length_unit_;
};

extern const ObserverKind probes;

}  // namespace rouleau::observe
