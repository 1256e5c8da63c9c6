#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "service/known_machine.h"
#include "service/queue/live_jobs.h"
#include "service/queue/signal_board.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// The workers of this process: each claims a job, runs it to its end and claims the next. A thread of its
/// own, which never computes, renews their leases.
class Queue {
 public:
  /// @param archives folder for the archives; made if it is not there
  /// @param machine  that the plans in the archives are for
  Queue(storage::JobStore& store, std::filesystem::path archives, KnownMachine& machine);
  /// Drains.
  ~Queue();
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  /// Takes back what a dead process held and begins to work.
  void start(int workers);

  /// A job was submitted.
  void wake();

  /// Makes a running job stop for a cancellation that the store has on record.
  void cancel(std::string_view id);

  /// Stops the runs, gives their jobs back to the queue and returns when all workers have ended.
  void drain();

  int workers() const { return static_cast<int>(workers_.size()); }
  LiveJobs& live() { return live_; }
  SignalBoard& changes() { return changes_; }
  const std::filesystem::path& archives() const { return archives_; }

 private:
  void work();
  bool work_once();
  void renew_leases();
  void keep_leases();

  storage::JobStore& store_;
  const std::filesystem::path archives_;
  KnownMachine& machine_;
  const std::string owner_;
  LiveJobs live_;
  SignalBoard changes_;

  std::mutex mutex_;
  std::condition_variable woken_;
  std::uint64_t wakes_ = 0;
  bool draining_ = false;
  bool leases_needed_ = true;
  std::vector<std::thread> workers_;
  std::thread heartbeat_;
};

}  // namespace rouleau::service
