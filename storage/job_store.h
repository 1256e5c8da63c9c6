#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/job.h"
#include "storage/store_error.h"
#include "storage/sweep.h"

namespace rouleau::storage {

/// Where the store takes the time from. Called from several threads.
using Clock = std::function<TimeMs()>;

TimeMs system_clock_ms();

/// The durable queue: one SQLite file in a data folder that one process holds at a time. Every change is on
/// the disk when its call returns; changes asked for at the same moment share one commit. Safe to call from
/// any thread.
///
///     queued -> running -> succeeded, failed                by claim, succeed, fail
///     queued -> succeeded                                   with the result of another job of the same hash
///     queued, paused -> cancelled; running -> cancelling    by request_cancel
///     cancelling -> cancelled                               by mark_cancelled
///     queued -> paused; running -> running, then paused     by request_pause, release
///     paused -> queued                                      by resume
///     failed, cancelled -> queued                           by retry
///     running -> queued; cancelling -> cancelled            by release, expire_leases, recover
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

  /// A job whose result is there has succeeded at once, unless it is to be computed afresh.
  /// @throws IdempotencyMismatch
  Submission submit(NewJob job, const std::optional<IdempotencyKey>& key = {});

  /// What was answered to the request that used this key before, if one did.
  /// @throws IdempotencyMismatch
  std::optional<Submission> find_submission(const IdempotencyKey& key);
  std::optional<SweepSubmission> find_sweep_submission(const IdempotencyKey& key);

  /// Keys that were used before this time may be used for something else.
  int forget_keys(TimeMs before);

  std::optional<Job> find(std::string_view id);
  std::optional<CaseText> case_text(std::string_view id);
  JobPage list(const JobQuery& query);
  QueueState queue_state();
  /// Whether a job or a sweep of this id was removed to make room.
  bool has_expired(std::string_view id);

  /// The job whose turn it is, if any: of the highest priority, of the lane that was served longest ago, the
  /// oldest. One that runs already is not run twice at a time: whoever wants the same result waits for it.
  /// `owner` names the process (or the node) that will run it.
  /// @param gave_results  set where jobs whose turn it was have succeeded with the result of another
  std::optional<ClaimedJob> claim(std::string_view owner, std::chrono::milliseconds lease,
                                  bool* gave_results = nullptr);

  /// Keeps the job for another `lease` from now, and stores how far it is.
  Lease renew(std::string_view id, int attempt, std::chrono::milliseconds lease,
              const std::optional<std::string>& progress = {});

  /// The attempt has left a checkpoint: it was not in vain if it dies.
  bool note_checkpoint(std::string_view id, int attempt);

  /// These four end an attempt; false: it is no longer this worker's. A run that ends while its
  /// cancellation is on the way keeps the end that it came to. Success is given to all that wait for the
  /// same result.
  bool succeed(std::string_view id, int attempt, const JobResult& result);
  /// @param result  of a run that failed on its way
  bool fail(std::string_view id, int attempt, const std::string& error,
            const std::optional<JobResult>& result = {});
  bool mark_cancelled(std::string_view id, int attempt);
  /// Back to the queue, and if `not_before` is given as a setback and to be claimed no earlier than then. A
  /// job being cancelled is then cancelled, one that was to pause is paused.
  bool release(std::string_view id, int attempt, std::optional<TimeMs> not_before = {});

  /// The job after the request, or none if there is no such job. Asking again changes nothing.
  /// @throws InvalidTransition where the state that it is in does not allow it
  std::optional<Job> request_cancel(std::string_view id);
  std::optional<Job> request_pause(std::string_view id);
  std::optional<Job> resume(std::string_view id);
  std::optional<Job> retry(std::string_view id);

  enum class Removal { asked_for, expired };
  /// Forgets a job that has ended, or none if there is no such job; with the last of its jobs a sweep goes,
  /// too. If it `expired`, its id is remembered.
  /// @throws InvalidTransition
  std::optional<Removed> remove(std::string_view id, Removal how = Removal::asked_for);

  /// All jobs of a sweep or none of them, each as `submit` would have it; their places are given here.
  /// @throws IdempotencyMismatch
  SweepSubmission submit_sweep(const NewSweep& sweep, std::vector<NewJob> jobs,
                               const std::optional<IdempotencyKey>& key = {});
  std::optional<Sweep> find_sweep(std::string_view id);
  /// Whether a job of it has not ended.
  bool sweep_is_active(std::string_view id);
  /// In the order of their index; those that were removed are not among them.
  std::vector<SweepJob> sweep_jobs(std::string_view id, bool with_summaries);
  /// @throws StoreError on a page token that no page gave
  SweepPage list_sweeps(int page_size, const std::string& page_token);
  /// Cancels what of it has not ended.
  CancelledJobs request_cancel_sweep(std::string_view id);

  /// In the order in which they ended, but for those of a sweep that has not.
  /// @param after  only those behind this one
  std::vector<EndedJob> oldest_ended(int limit, const std::optional<EndedJob>& after = {});
  /// What all archives take; one that several jobs share counts once.
  std::int64_t archive_bytes();

  /// While paused nothing is claimed; this outlasts a restart.
  void pause_queue(bool paused);

  /// At start-up: what another owner held goes back to the queue, for that owner is dead (the data folder is
  /// ours now). Returns how many jobs that were.
  int recover(std::string_view owner);

  /// The same for whatever has a lease that ran out.
  int expire_leases();

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace rouleau::storage
