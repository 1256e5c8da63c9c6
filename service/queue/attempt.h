#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "engine/simulation/run_failure.h"
#include "service/known_machine.h"
#include "service/queue/live_jobs.h"
#include "storage/archive_writer.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// How long a claim holds without being renewed.
inline constexpr std::chrono::milliseconds lease_time{10000};
/// A job that was begun this often and never ended takes its server down with it; it is begun no more.
inline constexpr int most_attempts = 20;

/// Where the archive of a job lies once the job has succeeded, or failed with one.
std::filesystem::path archive_path(const std::filesystem::path& archives, std::string_view id);

/// Removes what dead attempts left half written.
void remove_unfinished_archives(const std::filesystem::path& archives);

/// One attempt at a job, from its claim to its end in the store. Throws nothing that a run may throw: that
/// becomes the job's error, or a later attempt.
class Attempt {
 public:
  Attempt(storage::JobStore& store, LiveJobs& live, const std::filesystem::path& archives,
          KnownMachine& machine, storage::ClaimedJob claimed);

  void run();

 private:
  void compute();
  /// @param failure  of a run that ended in one: what it came to is kept with it
  void publish(storage::ArchiveWriter& writer, const RunSummary& summary,
               const RunFailure* failure = nullptr);
  void end_stopped();
  void end_failed(const std::exception& error);
  void log_failed(const std::exception& error) const;

  storage::JobStore& store_;
  LiveJobs& live_jobs_;
  storage::ClaimedJob claimed_;
  std::shared_ptr<LiveJob> live_;
  std::filesystem::path archive_;
  KnownMachine& machine_;
  bool has_archive_ = false;
};

}  // namespace rouleau::service
