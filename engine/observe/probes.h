#pragma once

#include <vector>

#include "engine/effects/state.h"
#include "engine/observe/output.h"

namespace rouleau::observe {

/// Samples the case's probes. What does not change is found once: which of their points lie in the fluid
/// and which parts of their lines the flux goes through.
class Probes {
 public:
  explicit Probes(const effects::State& state);

  /// The probes as the header has them.
  std::vector<ProbeLine> lines() const;

  /// One entry a probe.
  std::vector<ProbeValues> sample(const effects::State& state) const;

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

}  // namespace rouleau::observe
