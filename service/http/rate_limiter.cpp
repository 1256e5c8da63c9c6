#include "service/http/rate_limiter.h"

#include <algorithm>

namespace rouleau::service {

double RateLimiter::level_at(const Bucket& bucket, Clock::time_point now) const {
  const double passed = std::chrono::duration<double>(now - bucket.at).count();
  return std::min(limit_.burst, bucket.level + limit_.per_second * passed);
}

RateLimiter::Verdict RateLimiter::take(const std::string& caller, Clock::time_point now) {
  if (buckets_.size() >= forget_at_) forget_full_ones(now);
  Bucket& bucket = buckets_.try_emplace(caller, Bucket{limit_.burst, now}).first->second;
  bucket.level = level_at(bucket, now);
  bucket.at = now;
  Verdict verdict;
  verdict.admitted = bucket.level >= 1;
  if (verdict.admitted) bucket.level -= 1;
  verdict.left = bucket.level;
  verdict.full_in_s = (limit_.burst - bucket.level) / limit_.per_second;
  verdict.retry_in_s = std::max(0.0, 1 - bucket.level) / limit_.per_second;
  return verdict;
}

void RateLimiter::forget_full_ones(Clock::time_point now) {
  std::erase_if(buckets_, [&](const auto& entry) { return level_at(entry.second, now) >= limit_.burst; });
  // Not at every request, should few of them be full.
  forget_at_ = std::max<std::size_t>(1024, 2 * buckets_.size());
}

}  // namespace rouleau::service
