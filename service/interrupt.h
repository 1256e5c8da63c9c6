#pragma once

#include <csignal>
#include <functional>
#include <thread>

namespace rouleau::service {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process but call a function, on a thread of its
/// own. To be made before any other thread, which then inherits the blocked signals.
class InterruptHandler {
 public:
  explicit InterruptHandler(std::function<void()> on_interrupt);
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

 private:
  std::thread waiter_;
  sigset_t before_;
};

/// Blocks those signals in this thread and the threads it makes.
void block_interrupts();
/// Waits for one of them.
/// @return its number
int wait_for_interrupt();

}  // namespace rouleau::service
