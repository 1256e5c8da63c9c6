#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "storage/job.h"
#include "storage/store_error.h"

namespace rouleau::storage {

/// Where the store takes the time from. Called from several threads.
using Clock = std::function<TimeMs()>;

TimeMs system_clock_ms();

/// The durable queue: one SQLite file in a data folder that one process holds at a time. Every change is on
/// the disk when its call returns; changes asked for at the same moment share one commit. Safe to call from
/// any thread.
///
///     queued -> running -> succeeded, failed            by claim, succeed, fail
///     queued -> cancelled; running -> cancelling        by request_cancel
///     cancelling -> cancelled                           by mark_cancelled
///     running -> queued; cancelling -> cancelled        by release, expire_leases, recover
///
/// Whoever holds a job names it by id and attempt. If the attempt is no longer the job's own (the lease ran
/// out and somebody else claimed it), the call changes nothing and says so: a worker that lost its lease
/// cannot publish.
///
/// Each call may throw StoreError.
class JobStore {
 public:
  /// Makes the folder and the database if they are not there and brings the schema up to date.
  explicit JobStore(const std::filesystem::path& folder, Clock clock = system_clock_ms);
  ~JobStore();
  JobStore(const JobStore&) = delete;
  JobStore& operator=(const JobStore&) = delete;

  Job submit(NewJob job);

  std::optional<Job> find(std::string_view id);
  std::optional<CaseText> case_text(std::string_view id);
  JobPage list(const JobQuery& query);
  /// One entry a state, zeros too.
  std::map<JobState, std::int64_t> counts();

  /// The job whose turn it is, if any: the highest priority, then the oldest. `owner` names the process (or
  /// the node) that will run it.
  std::optional<ClaimedJob> claim(std::string_view owner, std::chrono::milliseconds lease);

  /// Keeps the job for another `lease` from now, and stores how far it is.
  Lease renew(std::string_view id, int attempt, std::chrono::milliseconds lease,
              const std::optional<std::string>& progress = {});

  /// These four end an attempt; false: it is no longer this worker's. A run that ends while its
  /// cancellation is on the way keeps the end that it came to.
  bool succeed(std::string_view id, int attempt, const JobResult& result);
  /// @param result  of a run that failed on its way
  bool fail(std::string_view id, int attempt, const std::string& error,
            const std::optional<JobResult>& result = {});
  bool mark_cancelled(std::string_view id, int attempt);
  /// Back to the queue, to be claimed no earlier than `not_before`; a job being cancelled is then cancelled.
  bool release(std::string_view id, int attempt, std::optional<TimeMs> not_before = {});

  /// The job after the request, or none if there is no such job. Asking again changes nothing.
  /// @throws InvalidTransition if it succeeded or failed
  std::optional<Job> request_cancel(std::string_view id);

  /// At start-up: what another owner held goes back to the queue, for that owner is dead (the data folder is
  /// ours now). Returns how many jobs that were.
  int recover(std::string_view owner);

  /// The same for whatever has a lease that ran out.
  int expire_leases();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rouleau::storage
