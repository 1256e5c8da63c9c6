#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/simulation/run_failure.h"
#include "service/known_machine.h"
#include "service/queue/job_files.h"
#include "service/queue/job_logs.h"
#include "service/queue/live_jobs.h"
#include "storage/archive_writer.h"
#include "storage/interrupted_run.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// How long a claim holds without being renewed.
inline constexpr std::chrono::milliseconds lease_time{10000};
/// A job that was begun this often in a row and came to no checkpoint takes its server down with it; it is
/// begun no more.
inline constexpr int most_setbacks = 20;
/// After so many it no longer goes on from its checkpoint: that may be what it dies of. More than the tries
/// that a full disk gets.
inline constexpr int setbacks_until_anew = 8;

/// Where attempts do their work.
struct Workplace {
  storage::JobStore& store;
  LiveJobs& live;
  JobLogs& logs;
  KnownMachine& machine;
  std::filesystem::path archives;
  /// Between checkpoints; infinite: only when a run is stopped.
  std::chrono::duration<double> checkpoint_interval{60};
};

/// One attempt at a job, from its claim to its end in the store: from the job's last checkpoint, if an
/// earlier one left any. Throws nothing that a run may throw: that becomes the job's error, or a later
/// attempt.
class Attempt {
 public:
  Attempt(Workplace& place, storage::ClaimedJob claimed);

  void run();

 private:
  void compute();
  RunSummary run_on(const Case& resolved);
  RunSummary run_from(const Case& resolved, const storage::InterruptedRun* interrupted);
  std::optional<storage::InterruptedRun> find_interrupted(const Case& resolved);
  void begin_anew(const std::string& why);
  /// @param failure  of a run that ended in one: what it came to is kept with it
  void publish(const RunSummary& summary, const RunFailure* failure = nullptr);
  /// Ends the job with an archive that has its name.
  void record(const storage::JobResult& result, const RunFailure* failure = nullptr);
  void end_stopped();
  void end_failed(const std::exception& error);
  void note_failed(const std::exception& error);

  const storage::Job& job() const { return claimed_.job; }

  Workplace& place_;
  storage::ClaimedJob claimed_;
  std::shared_ptr<LiveJob> live_;
  std::filesystem::path archive_;
  std::optional<storage::ArchiveWriter> writer_;
  bool has_archive_ = false;
};

}  // namespace rouleau::service
