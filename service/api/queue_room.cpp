#include "service/api/queue_room.h"

#include <string>

#include "service/http/problem.h"

namespace rouleau::service {

void QueueRoom::enter(std::int64_t jobs) {
  if (jobs > most_) {
    throw Problem(problems::sweep_too_large, std::to_string(jobs) + " jobs at once; at most " +
                                                 std::to_string(most_) + " may wait (--max-queued)");
  }
  check_space_();
  constexpr std::chrono::milliseconds old{250};
  const std::lock_guard lock(mutex_);
  if (const auto now = Clock::now(); now - counted_ > old) {
    waiting_ = store_.queue_state().counts.at(storage::JobState::queued);
    counted_ = now;
  }
  if (waiting_ + jobs > most_) {
    throw Problem(problems::queue_full, std::to_string(waiting_) + " jobs wait; there is room for " +
                                            std::to_string(most_) + " (--max-queued)");
  }
  waiting_ += jobs;
}

}  // namespace rouleau::service
