#include "service/queue/attempt_notes.h"

#include <fmt/format.h>

#include "engine/simulation/checkpoint.h"

namespace rouleau::service {

void AttemptNotes::checkpoint(const Checkpoint& checkpoint) {
  const CheckpointHead head = head_of(checkpoint, resolved_);
  logs_.note_routine(job_, "checkpoint",
                     {{"step", std::to_string(head.steps)},
                      {"simulated_time", fmt::format("{:.6g}", head.simulated_time)},
                      {"bytes", std::to_string(checkpoint.bytes.size())}});
  if (!noted_) noted_ = store_.note_checkpoint(job_.id, job_.attempt);
}

void note_summary(JobLogs& logs, const storage::Job& job, const RunSummary& summary) {
  for (const Refinement& refinement : summary.refinements) {
    logs.note_end(job, "refined",
                  {{"simulated_time", fmt::format("{:.6g}", refinement.time)},
                   {"cell", std::to_string(refinement.cell)},
                   {"spacing", fmt::format("{:.4g}", refinement.spacing)}});
  }
  for (const std::string& warning : summary.warnings) logs.note_end(job, "warning", {{"text", warning}});
  logs.note_end(job, "ended",
                {{"reason", summary.reason},
                 {"simulated_time", fmt::format("{:.6g}", summary.simulated_time)},
                 {"steps", std::to_string(summary.steps)},
                 {"wall_time_s", fmt::format("{:.3f}", summary.wall_time)}});
}

}  // namespace rouleau::service
