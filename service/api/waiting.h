#pragma once

#include <atomic>
#include <chrono>

#include "service/http/router.h"

namespace rouleau::service {

/// How long a client wants to wait for a change (`wait=20s`), a minute at most; 0 if it does not.
/// @throws Problem 400
std::chrono::milliseconds read_wait(const Call& call);

/// Counts a request among those that wait. Each holds one of the server's threads: when there are too many, a
/// client is answered at once and asks again.
class Waiting {
 public:
  explicit Waiting(std::atomic<int>& count) : count_(count), now_(++count) {}
  ~Waiting() { --count_; }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  bool too_many() const;

 private:
  std::atomic<int>& count_;
  const int now_;
};

}  // namespace rouleau::service
