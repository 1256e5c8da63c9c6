#include <random>
#include <set>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/child_process.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

/// Submits from four threads until it is killed, telling each id that it was given.
void submit_for_ever(const std::filesystem::path& folder, const ChildProcess::Tell& tell) {
  JobStore store(folder);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      while (true) tell(store.submit(plain_job()).job.id);
    });
  }
  for (auto& thread : threads) thread.join();
}

std::set<std::string> whole_lines(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line) && !stream.eof()) lines.insert(line);
  return lines;
}

TEST(Crash, EveryAcceptedJobOutlivesKill) {
  const ScratchFolder folder;
  std::set<std::string> accepted;
  std::mt19937 random(20240917);
  std::uniform_int_distribution<int> delay_ms(5, 120);
  for (int round = 0; round < 8; ++round) {
    ChildProcess child([&](const ChildProcess::Tell& tell) { submit_for_ever(folder.path(), tell); });
    const std::string first = child.read_line();
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms(random)));
    child.kill();
    accepted.insert(first);
    accepted.merge(whole_lines(child.read_all()));

    JobStore store(folder.path());
    for (const std::string& id : accepted) {
      ASSERT_TRUE(store.find(id)) << "lost " << id << " in round " << round;
      ASSERT_TRUE(store.case_text(id));
    }
  }
  EXPECT_GT(accepted.size(), 8u);
}

TEST(Crash, AClaimedJobComesBackAndItsWorkerIsFenced) {
  const ScratchFolder folder;
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    JobStore store(folder.path());
    store.submit(plain_job());
    tell(store.claim("first life", std::chrono::hours(1)).value().job.id);
    pause();
  });
  const std::string id = child.read_line();
  child.kill();
  JobStore store(folder.path());
  EXPECT_EQ(store.find(id)->state, JobState::running);
  EXPECT_EQ(store.recover("second life"), 1);
  EXPECT_EQ(store.claim("second life", std::chrono::seconds(10))->job.attempt, 2);
  EXPECT_FALSE(store.succeed(id, 1, some_result));
  EXPECT_TRUE(store.succeed(id, 2, some_result));
}

}  // namespace
}  // namespace rouleau::storage
