#pragma once

#include <utility>

#include "engine/error/simulation_error.h"
#include "engine/simulation/run.h"

namespace rouleau {

/// A run that went unstable, with what it came to until then: whatever its output was given is whole.
class RunFailure : public SimulationError {
 public:
  RunFailure(const SimulationError& cause, RunSummary summary)
      : SimulationError(cause), summary_(std::move(summary)) {}

  const RunSummary& summary() const { return summary_; }

 private:
  RunSummary summary_;
};

}  // namespace rouleau
