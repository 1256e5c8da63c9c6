#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>

#include "storage/job_store.h"

namespace rouleau::service {

/// Keeps the queue from growing without bound. It counts what waits a few times a second, and in between what
/// it let in.
class QueueRoom {
 public:
  /// @param check_space  throws where there is no room for results
  QueueRoom(
      storage::JobStore& store, std::int64_t most, std::function<void()> check_space = [] {})
      : store_(store), most_(most), check_space_(std::move(check_space)) {}

  /// @param jobs about to be submitted together
  /// @throws Problem 422 sweep-too-large, 503 queue-full, no-space
  void enter(std::int64_t jobs);

 private:
  using Clock = std::chrono::steady_clock;

  storage::JobStore& store_;
  const std::int64_t most_;
  const std::function<void()> check_space_;
  std::mutex mutex_;
  std::int64_t waiting_ = 0;
  Clock::time_point counted_{};
};

}  // namespace rouleau::service
