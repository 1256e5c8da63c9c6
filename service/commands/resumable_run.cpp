#include "service/commands/resumable_run.h"

#include <vector>

#include "service/queue/fan_out.h"

namespace rouleau::service {

RunEnd run_resumable(const ResumableRun& run, const std::optional<storage::InterruptedRun>& interrupted,
                     Output& progress, const std::stop_token& stop) {
  storage::ArchiveWriter writer(run.archive, run.given);
  storage::CheckpointKeeper checkpoints(run.archive);
  std::vector<Output*> outputs{&writer, &checkpoints, &progress};
  std::optional<storage::ResumedOutput> resumed;
  if (interrupted) {
    outputs.push_back(&resumed.emplace(*interrupted, writer));
  } else {
    checkpoints.remove();
  }
  FanOut output(outputs);
  RunEnd end;
  try {
    end.summary =
        run_case(run.resolved, output, stop,
                 {interrupted ? &interrupted->checkpoint : nullptr, run.checkpoint_interval}, run.machine);
  } catch (const RunFailure& failure) {
    end.failure = failure;
    end.summary = failure.summary();
  }
  end.file = writer.finish(end.summary);
  if (end.summary.ending != Ending::stopped) checkpoints.remove();
  return end;
}

}  // namespace rouleau::service
