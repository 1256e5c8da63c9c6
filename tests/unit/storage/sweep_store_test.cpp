#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "storage/store_error.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

using ::testing::ElementsAre;

constexpr std::chrono::seconds lease{30};

NewSweep plain_sweep(const std::string& name = "sweep") {
  NewSweep sweep;
  sweep.name = name;
  sweep.given = R"({"axes":[]})";
  return sweep;
}

std::vector<NewJob> jobs(int count) {
  std::vector<NewJob> made;
  for (int k = 0; k < count; ++k) made.push_back(plain_job("#" + std::to_string(k)));
  return made;
}

TEST(SweepStore, KeepsASweepAndItsJobsInTheirOrder) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  const Sweep sweep = store.submit_sweep(plain_sweep(), jobs(3)).sweep;
  EXPECT_EQ(sweep.counts.at(JobState::queued), 3);
  EXPECT_EQ(store.find_sweep(sweep.id)->name, "sweep");
  EXPECT_FALSE(store.find_sweep("none"));

  const auto members = store.sweep_jobs(sweep.id, false);
  ASSERT_EQ(members.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    const auto job = store.find(members[static_cast<std::size_t>(k)].id);
    EXPECT_EQ(job->name, "#" + std::to_string(k));
    EXPECT_EQ(job->place->sweep, sweep.id);
    EXPECT_EQ(job->place->index, k);
  }
  EXPECT_EQ(store.claim("me", lease)->job.id, members[0].id);
  EXPECT_EQ(store.find_sweep(sweep.id)->counts.at(JobState::running), 1);
}

TEST(SweepStore, AllJobsAreStoredOrNone) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  auto bad = jobs(3);
  bad[2].labels = "no JSON";
  EXPECT_THROW(store.submit_sweep(plain_sweep(), bad), StoreError);
  EXPECT_TRUE(store.list({}).jobs.empty());
  EXPECT_TRUE(store.list_sweeps(50, "").sweeps.empty());
}

TEST(SweepStore, TakesResultsThatAreThere) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  auto points = jobs(2);
  store.submit(points[1]);
  const Job ran = store.claim("me", lease)->job;
  store.succeed(ran.id, ran.attempt, some_result);

  const Sweep sweep = store.submit_sweep(plain_sweep(), points).sweep;
  EXPECT_EQ(sweep.counts.at(JobState::succeeded), 1);
  const auto members = store.sweep_jobs(sweep.id, true);
  EXPECT_EQ(members[1].summary, some_result.summary);
  EXPECT_FALSE(members[0].summary);
  EXPECT_EQ(store.find(members[1].id)->result_of, ran.id);
}

TEST(SweepStore, AKeyAnswersWithTheSameSweep) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  const IdempotencyKey key{"me", "key", std::string(64, '1')};
  const auto first = store.submit_sweep(plain_sweep(), jobs(2), key);
  const auto again = store.submit_sweep(plain_sweep(), jobs(2), key);
  EXPECT_FALSE(first.replayed);
  EXPECT_TRUE(again.replayed);
  EXPECT_EQ(first.sweep.id, again.sweep.id);
  EXPECT_EQ(store.list({}).jobs.size(), 2u);
  const IdempotencyKey other{"me", "key", std::string(64, '2')};
  EXPECT_THROW(store.submit_sweep(plain_sweep(), jobs(2), other), IdempotencyMismatch);
  EXPECT_THROW(store.submit(plain_job(), other), IdempotencyMismatch);
}

TEST(SweepStore, ASweepGoesWithTheLastOfItsJobs) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  for (const auto how : {JobStore::Removal::asked_for, JobStore::Removal::expired}) {
    const std::string id =
        store.submit_sweep(plain_sweep(), jobs(2), IdempotencyKey{"me", "key", std::string(64, 'f')})
            .sweep.id;
    store.request_cancel_sweep(id);
    const auto members = store.sweep_jobs(id, false);
    store.remove(members[0].id, how);
    EXPECT_TRUE(store.find_sweep(id));
    store.remove(members[1].id, how);
    EXPECT_FALSE(store.find_sweep(id));
    EXPECT_EQ(store.has_expired(id), how == JobStore::Removal::expired);
  }
}

TEST(SweepStore, CancellingEndsWhatWaitsAndNamesWhatRuns) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  const std::string id = store.submit_sweep(plain_sweep(), jobs(4)).sweep.id;
  const Job ended = store.claim("me", lease)->job;
  store.succeed(ended.id, ended.attempt, some_result);
  const Job running = store.claim("me", lease)->job;
  store.request_pause(store.sweep_jobs(id, false)[3].id);

  EXPECT_TRUE(store.sweep_is_active(id));
  const Job released = store.claim("me", lease)->job;
  store.release(released.id, released.attempt);
  const CancelledJobs cancelled = store.request_cancel_sweep(id);
  EXPECT_THAT(cancelled.running, ElementsAre(running.id));
  EXPECT_THAT(cancelled.had_progress, ElementsAre(released.id));
  auto counts = store.find_sweep(id)->counts;
  EXPECT_EQ(counts[JobState::succeeded], 1);
  EXPECT_EQ(counts[JobState::cancelling], 1);
  EXPECT_EQ(counts[JobState::cancelled], 2);
  store.mark_cancelled(running.id, running.attempt);
  EXPECT_FALSE(store.sweep_is_active(id));
  EXPECT_TRUE(store.request_cancel_sweep(id).running.empty());
}

TEST(SweepStore, ListsTheNewestFirstInPages) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  for (const char* name : {"a", "b", "c"}) store.submit_sweep(plain_sweep(name), jobs(1));
  const SweepPage first = store.list_sweeps(2, "");
  ASSERT_EQ(first.sweeps.size(), 2u);
  EXPECT_EQ(first.sweeps[0].name, "c");
  EXPECT_EQ(first.sweeps[0].counts.at(JobState::queued), 1);
  const SweepPage second = store.list_sweeps(2, first.next_page_token.value());
  ASSERT_EQ(second.sweeps.size(), 1u);
  EXPECT_EQ(second.sweeps[0].name, "a");
  EXPECT_FALSE(second.next_page_token);
  EXPECT_THROW(store.list_sweeps(2, "nonsense"), StoreError);
}

}  // namespace
}  // namespace rouleau::storage
