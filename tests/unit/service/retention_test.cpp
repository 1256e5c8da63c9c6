#include "service/retention.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "service/http/problem.h"
#include "service/queue/job_files.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::service {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds lease{10'000};
constexpr storage::TimeMs hour = 3'600'000;

/// A store with four jobs that succeeded, an hour after one another, with archives of 1000 bytes.
class RetentionOf : public testing::Test {
 protected:
  RetentionOf() : store(folder.path(), time.clock()) {
    for (int k = 0; k < 4; ++k) {
      jobs.push_back(succeed(storage::plain_job("job " + std::to_string(k))));
      time.now += hour;
    }
  }

  std::string succeed(storage::NewJob job) {
    job.fresh = true;
    store.submit(job);
    const auto claimed = store.claim("me", lease).value();
    store.succeed(claimed.job.id, claimed.job.attempt, {"{}", 1000, std::string(64, 'a')});
    return claimed.job.id;
  }

  Retention retention(RetentionRules rules) {
    return Retention(
        store, use, folder.path(), rules,
        [this](const std::string& id, const std::optional<std::string>& archive) {
          forgotten.push_back(id);
          EXPECT_EQ(archive, id);
        },
        time.clock());
  }

  std::vector<std::string> left() {
    std::vector<std::string> ids;
    for (const auto& job : store.list({.page_size = 100}).jobs) ids.insert(ids.begin(), job.id);
    return ids;
  }

  std::vector<std::string> some(std::vector<std::size_t> places) const {
    std::vector<std::string> ids;
    for (const std::size_t k : places) ids.push_back(jobs[k]);
    return ids;
  }

  storage::ScratchFolder folder;
  storage::BentClock time;
  storage::JobStore store;
  ArchiveUse use;
  std::vector<std::string> jobs;
  std::vector<std::string> forgotten;
};

TEST_F(RetentionOf, EverythingRemovesNothing) {
  retention({}).run();
  EXPECT_EQ(left(), jobs);
}

TEST_F(RetentionOf, AgeRemovesWhatIsOlderAndRemembersIt) {
  retention({.keep = 2.5h}).run();
  EXPECT_EQ(left(), some({2, 3}));
  EXPECT_EQ(forgotten, some({0, 1}));
  EXPECT_TRUE(store.has_expired(jobs[0]));
  EXPECT_FALSE(store.has_expired(jobs[2]));
}

TEST_F(RetentionOf, SpaceRemovesTheOldestUntilTheRestFits) {
  auto rules = RetentionRules{.most_archive_bytes = 2500};
  Retention tidy = retention(rules);
  tidy.run();
  EXPECT_EQ(left(), some({2, 3}));
  tidy.check_room();
}

TEST_F(RetentionOf, WhatIsReadStays) {
  const auto reading = use.begin(jobs[0]);
  retention({.keep = 1.5h}).run();
  EXPECT_EQ(left(), some({0, 3}));
}

TEST_F(RetentionOf, WhatHasNotEndedStays) {
  const std::string waiting = store.submit(storage::plain_job("waits")).job.id;
  time.now += 100 * hour;
  retention({.keep = 1h, .most_archive_bytes = 0}).run();
  EXPECT_EQ(left(), std::vector<std::string>{waiting});
}

TEST_F(RetentionOf, NoRoomThatCanBeMadeLetsNoJobIn) {
  const auto reading = use.begin(jobs[3]);
  auto rules = RetentionRules{.most_archive_bytes = 500};
  Retention tidy = retention(rules);
  tidy.run();
  EXPECT_EQ(left(), some({3}));
  EXPECT_THROW(tidy.check_room(), Problem);
  store.remove(jobs[3]);
  tidy.check_room();
}

TEST_F(RetentionOf, AFullDiskLetsNoJobIn) {
  const auto archives = folder.path() / "archives";
  std::filesystem::create_directories(archives);
  for (const std::string& id : jobs) std::ofstream(archive_path(archives, id)) << "1000 bytes";
  std::filesystem::create_hard_link(archive_path(archives, jobs[1]), folder.path() / "backup");
  Retention tidy = retention({.least_free_bytes = std::uint64_t{1} << 60});
  EXPECT_THROW(tidy.check_room(), Problem);
  tidy.run();
  EXPECT_EQ(left(), some({1})) << "whose archive a backup links to: its bytes would stay";
}

}  // namespace
}  // namespace rouleau::service
