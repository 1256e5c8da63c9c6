#pragma once

#include "engine/observe/run_summary.h"
#include "engine/simulation/output.h"
#include "service/queue/job_logs.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// To be told of a run behind whoever keeps its checkpoints: notes each in the job's log, and the first of an
/// attempt in the store.
class AttemptNotes : public Output {
 public:
  AttemptNotes(storage::JobStore& store, JobLogs& logs, const storage::Job& job, const Case& resolved)
      : store_(store), logs_(logs), job_(job), resolved_(resolved) {}

  void checkpoint(const Checkpoint& checkpoint) override;

 private:
  storage::JobStore& store_;
  JobLogs& logs_;
  const storage::Job& job_;
  const Case& resolved_;
  bool noted_ = false;
};

/// What a run that has ended says of itself, in the job's log: how it ended, its refinements and warnings.
void note_summary(JobLogs& logs, const storage::Job& job, const RunSummary& summary);

}  // namespace rouleau::service
