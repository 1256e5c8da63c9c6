#include "service/client/retry.h"

#include <algorithm>
#include <thread>

namespace rouleau::service {

bool Retry::wait(std::chrono::milliseconds asked_for) {
  constexpr std::chrono::milliseconds longest_gap{5000};
  if (left_.count() <= 0) return false;
  const auto pause = std::min(asked_for.count() > 0 ? asked_for : gap_, left_);
  if (asked_for.count() <= 0) gap_ = std::min(2 * gap_, longest_gap);
  left_ -= pause;
  std::this_thread::sleep_for(pause);
  return true;
}

}  // namespace rouleau::service
