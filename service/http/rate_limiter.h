#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <unordered_map>

namespace rouleau::service {

/// How many requests a caller may send. Each has a bucket that a request takes one from and that time fills.
struct RateLimit {
  double per_second = 0;  ///< 0: any number
  double burst = 0;       ///< what a bucket holds
};

/// The buckets of all callers. For one thread alone.
class RateLimiter {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RateLimiter(const RateLimit& limit) : limit_(limit) {}

  bool limits() const { return limit_.per_second > 0; }
  const RateLimit& limit() const { return limit_; }

  struct Verdict {
    bool admitted = true;
    double left = 0;        ///< requests that may follow at once
    double full_in_s = 0;   ///< until as many as ever may
    double retry_in_s = 0;  ///< until the next is admitted
  };
  Verdict take(const std::string& caller, Clock::time_point now);

  std::size_t buckets() const { return buckets_.size(); }

 private:
  struct Bucket {
    double level;
    Clock::time_point at;
  };
  double level_at(const Bucket& bucket, Clock::time_point now) const;
  void forget_full_ones(Clock::time_point now);

  const RateLimit limit_;
  std::unordered_map<std::string, Bucket> buckets_;
  std::size_t forget_at_ = 1024;
};

}  // namespace rouleau::service
