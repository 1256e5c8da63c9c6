#pragma once

#include <stop_token>

#include <nlohmann/json_fwd.hpp>

#include "engine/observe/run_summary.h"
#include "engine/simulation/output.h"

namespace rouleau {

/// The engine's version and a digest of its sources: the same version and the same case give the same bits.
/// Written when it is built.
const char* engine_version();

/// How a run can be interrupted and taken up again.
struct Continuation {
  /// What to go on from, if not from the start. `output.begin` is called all the same; rows and frames are
  /// those that come after the checkpoint.
  const Checkpoint* from = nullptr;
  /// s of wall time between checkpoints, and one more when the stop token ends the run; 0: none
  double interval = 0;
};

/// Runs a case from start to end, delivering to `output`. However often it is interrupted and taken up again,
/// what it delivers is the same to the last bit, but for the wall time spent.
/// @param machine  for the plan that it delivers
/// @throws CaseError if the case cannot be planned or a cell has no rest shape, RunFailure (a
/// SimulationError) if the run goes unstable, CheckpointError if it cannot go on from the checkpoint given
RunSummary run_case(const Case& resolved, Output& output, const std::stop_token& stop = {},
                    const Continuation& continuation = {}, const Machine& machine = {});

nlohmann::json to_json(const RunSummary& summary);

}  // namespace rouleau
