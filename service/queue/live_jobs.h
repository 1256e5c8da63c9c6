#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "service/queue/live_job.h"

namespace rouleau::service {

/// The jobs that run in this process, by id. Those that ended without an archive are kept a while, so that
/// whoever watched one can still see how far it came.
class LiveJobs {
 public:
  static constexpr std::size_t kept_after_end = 16;

  std::shared_ptr<LiveJob> start(const std::string& id, int attempt);
  /// @param keep whether its series and outlines are still worth showing
  void end(const std::shared_ptr<LiveJob>& job, bool keep);

  /// Of one that does not run, what was kept.
  void forget(std::string_view id);

  /// @return whether the job does not run, or has ended before the time is up
  bool wait_until_ended(std::string_view id, std::chrono::milliseconds patience) const;
  /// Running or kept; null if neither.
  std::shared_ptr<LiveJob> find(std::string_view id) const;
  std::vector<std::shared_ptr<LiveJob>> running() const;

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable ended_;
  std::map<std::string, std::shared_ptr<LiveJob>, std::less<>> running_;
  std::deque<std::shared_ptr<LiveJob>> kept_;
};

}  // namespace rouleau::service
