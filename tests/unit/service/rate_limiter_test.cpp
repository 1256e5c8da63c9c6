#include "service/http/rate_limiter.h"

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

using std::chrono::milliseconds;

TEST(RateLimiter, AdmitsABurstAndThenTheRate) {
  RateLimiter limiter({.per_second = 10, .burst = 3});
  const auto start = RateLimiter::Clock::now();
  for (int left = 2; left >= 0; --left) {
    const auto verdict = limiter.take("a", start);
    EXPECT_TRUE(verdict.admitted);
    EXPECT_DOUBLE_EQ(verdict.left, left);
  }
  const auto refused = limiter.take("a", start);
  EXPECT_FALSE(refused.admitted);
  EXPECT_NEAR(refused.retry_in_s, 0.1, 1e-9);
  EXPECT_NEAR(refused.full_in_s, 0.3, 1e-9);
  EXPECT_FALSE(limiter.take("a", start + milliseconds(99)).admitted);
  EXPECT_TRUE(limiter.take("a", start + milliseconds(101)).admitted);
  EXPECT_FALSE(limiter.take("a", start + milliseconds(102)).admitted);
}

TEST(RateLimiter, FillsNoFurtherThanTheBurst) {
  RateLimiter limiter({.per_second = 10, .burst = 2});
  const auto start = RateLimiter::Clock::now();
  limiter.take("a", start);
  EXPECT_DOUBLE_EQ(limiter.take("a", start + std::chrono::hours(1)).left, 1);
}

TEST(RateLimiter, CountsEachCallerApart) {
  RateLimiter limiter({.per_second = 1, .burst = 1});
  const auto now = RateLimiter::Clock::now();
  EXPECT_TRUE(limiter.take("a", now).admitted);
  EXPECT_FALSE(limiter.take("a", now).admitted);
  EXPECT_TRUE(limiter.take("b", now).admitted);
}

TEST(RateLimiter, ForgetsThoseWhoStayedAway) {
  RateLimiter limiter({.per_second = 1, .burst = 1});
  auto now = RateLimiter::Clock::now();
  for (int i = 0; i < 100000; ++i) limiter.take(std::to_string(i), now += milliseconds(1));
  EXPECT_LT(limiter.buckets(), 5000u);
}

}  // namespace
}  // namespace rouleau::service
