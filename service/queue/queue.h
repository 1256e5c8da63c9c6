#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "service/known_machine.h"
#include "service/queue/attempt.h"
#include "service/queue/job_logs.h"
#include "service/queue/live_jobs.h"
#include "service/queue/signal_board.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// The workers of this process: each claims a job, runs it to its end and claims the next. A thread of its
/// own, which never computes, renews their leases.
class Queue {
 public:
  /// @param data     folder for the archives and the logs, each in one of its own
  /// @param machine  that the plans in the archives are for
  /// @param checkpoint_interval  infinite: only when a run is stopped
  Queue(storage::JobStore& store, const std::filesystem::path& data, KnownMachine& machine,
        std::chrono::duration<double> checkpoint_interval);
  /// Drains.
  ~Queue();
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  /// Takes back what a dead process held and begins to work.
  void start(int workers);

  /// Is told of each job whose attempt has ended, as it was when that began. To be set before `start`.
  void watch(std::function<void(const storage::Job&)> on_attempt) { on_attempt_ = std::move(on_attempt); }

  /// A job was submitted.
  void wake();

  /// Makes a running job stop for a cancellation or a pause that the store has on record.
  void stop(std::string_view id, StopReason reason);

  /// Stops the runs at a checkpoint, gives their jobs back to the queue and returns when all workers have
  /// ended.
  void drain();

  /// Removes what a job that waited was to go on from.
  void drop_progress(std::string_view id);

  /// Removes the files of a job that the store has forgotten.
  /// @param archive_id  the archive that no other job has, if there is one
  void forget(std::string_view id, const std::optional<std::string>& archive_id);

  int workers() const { return worker_count_; }
  LiveJobs& live() { return live_; }
  JobLogs& logs() { return logs_; }
  SignalBoard& changes() { return changes_; }
  const std::filesystem::path& archives() const { return archives_; }

 private:
  void tidy_up();
  void work();
  bool work_once();
  void renew_leases();
  void keep_leases();

  storage::JobStore& store_;
  const std::filesystem::path archives_;
  const std::string owner_;
  std::function<void(const storage::Job&)> on_attempt_;
  LiveJobs live_;
  JobLogs logs_;
  Workplace place_;
  SignalBoard changes_;

  std::mutex mutex_;
  std::condition_variable woken_;
  std::uint64_t wakes_ = 0;
  bool draining_ = false;
  bool leases_needed_ = true;
  std::vector<std::thread> workers_;
  std::atomic<int> worker_count_ = 0;
  std::thread heartbeat_;
};

}  // namespace rouleau::service
