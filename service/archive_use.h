#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace rouleau::service {

/// Who reads which archive: what is being read, or was a moment ago, is not removed to make room. Safe to
/// call from any thread.
class ArchiveUse {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param grace  how long after a read its archive is still wanted: a client asks for one part after the
  ///               other
  explicit ArchiveUse(Clock::duration grace = std::chrono::minutes(5),
                      std::function<Clock::time_point()> now = Clock::now);

  /// The archive is being read as long as anybody has what this returns.
  std::shared_ptr<const void> begin(const std::string& archive_id) const;

  bool in_use(const std::string& archive_id) const;

 private:
  struct Use {
    int readers = 0;
    Clock::time_point last{};
  };
  struct Shared;

  std::shared_ptr<Shared> shared_;  // may outlive this in answers that are still being sent
};

}  // namespace rouleau::service
