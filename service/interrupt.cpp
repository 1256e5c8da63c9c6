#include "service/interrupt.h"

#include <pthread.h>
#include <utility>

namespace rouleau::service {

namespace {

sigset_t interrupts() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, number);
  return set;
}

}  // namespace

void block_interrupts() {
  const sigset_t set = interrupts();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

int wait_for_interrupt() {
  const sigset_t set = interrupts();
  int number = 0;
  sigwait(&set, &number);
  return number;
}

InterruptHandler::InterruptHandler(std::function<void()> on_interrupt) {
  sigset_t set = interrupts();
  sigaddset(&set, SIGUSR1);  // sent to the waiter alone, to end it
  pthread_sigmask(SIG_BLOCK, &set, &before_);
  waiter_ = std::thread([set, on_interrupt = std::move(on_interrupt)] {
    for (;;) {
      int number = 0;
      sigwait(&set, &number);
      if (number == SIGUSR1) return;
      on_interrupt();
    }
  });
}

InterruptHandler::~InterruptHandler() {
  pthread_kill(waiter_.native_handle(), SIGUSR1);
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace rouleau::service
