#include "service/archive_use.h"

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

TEST(ArchiveUse, LastsAsLongAsAnybodyReadsAndAMomentMore) {
  auto now = ArchiveUse::Clock::time_point(std::chrono::hours(1));
  ArchiveUse use(std::chrono::minutes(5), [&] { return now; });
  EXPECT_FALSE(use.in_use("a"));
  auto first = use.begin("a");
  const auto second = use.begin("a");
  first.reset();
  now += std::chrono::hours(10);
  EXPECT_TRUE(use.in_use("a"));
  EXPECT_FALSE(use.in_use("b"));
  auto third = second;
  EXPECT_TRUE(use.in_use("a"));
}

TEST(ArchiveUse, EndsAfterItsGrace) {
  auto now = ArchiveUse::Clock::time_point(std::chrono::hours(1));
  ArchiveUse use(std::chrono::minutes(5), [&] { return now; });
  use.begin("a");
  now += std::chrono::minutes(4);
  EXPECT_TRUE(use.in_use("a"));
  now += std::chrono::minutes(2);
  EXPECT_FALSE(use.in_use("a"));
}

TEST(ArchiveUse, MayEndAfterWhoeverAskedIsGone) {
  std::shared_ptr<const void> reading;
  {
    ArchiveUse use;
    reading = use.begin("a");
  }
  reading.reset();
}

}  // namespace
}  // namespace rouleau::service
