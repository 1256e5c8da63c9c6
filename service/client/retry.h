#pragma once

#include <chrono>

namespace rouleau::service {

/// When to try again, and when to give up.
class Retry {
 public:
  explicit Retry(std::chrono::seconds patience) : left_(patience) {}

  /// Sleeps as long as the server asked for, or else a gap that grows each time.
  /// @return false: patience is over, and it did not sleep
  bool wait(std::chrono::milliseconds asked_for = std::chrono::milliseconds(0));

 private:
  std::chrono::milliseconds left_;
  std::chrono::milliseconds gap_{100};
};

}  // namespace rouleau::service
