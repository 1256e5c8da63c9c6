#pragma once

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

  /// Running or kept; null if neither.
  std::shared_ptr<LiveJob> find(std::string_view id) const;
  std::vector<std::shared_ptr<LiveJob>> running() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<LiveJob>, std::less<>> running_;
  std::deque<std::shared_ptr<LiveJob>> kept_;
};

}  // namespace rouleau::service
