#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace rouleau::service {

/// Tells waiting threads that some job changed its state. They look for themselves whether it was theirs.
class SignalBoard {
 public:
  using Clock = std::chrono::steady_clock;

  std::uint64_t version() const {
    const std::lock_guard lock(mutex_);
    return version_;
  }

  void announce() {
    {
      const std::lock_guard lock(mutex_);
      ++version_;
    }
    changed_.notify_all();
  }

  /// Waits until there is news after `seen`, the board is closed, or the deadline passes.
  /// @return false if there was no news
  bool wait(std::uint64_t seen, Clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, deadline, [&] { return version_ != seen || closed_; });
    return version_ != seen;
  }

  /// Nobody waits from now on.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  bool closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t version_ = 0;
  bool closed_ = false;
};

}  // namespace rouleau::service
