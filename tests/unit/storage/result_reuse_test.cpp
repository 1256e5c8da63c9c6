#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

class ResultReuse : public testing::Test {
 protected:
  static constexpr std::chrono::seconds lease{10};

  std::string submitted(bool fresh = false) {
    NewJob again = same;
    again.fresh = fresh;
    return store.submit(again).job.id;
  }
  std::optional<std::string> claimed() {
    const auto claim = store.claim("me", lease);
    return claim ? std::optional(claim->job.id) : std::nullopt;
  }
  Job job(const std::string& id) { return store.find(id).value(); }

  ScratchFolder folder;
  BentClock time;
  JobStore store{folder.path(), time.clock()};
  NewJob same = plain_job();
};

TEST_F(ResultReuse, TheSameCaseAgainIsAnsweredAtOnce) {
  const std::string first = submitted();
  claimed();
  store.succeed(first, 1, some_result);
  const Job second = store.submit(same).job;
  EXPECT_EQ(second.state, JobState::succeeded);
  EXPECT_EQ(second.result_of, first);
  EXPECT_EQ(second.summary, some_result.summary);
  EXPECT_EQ(second.archive_id, first);
  EXPECT_EQ(second.archive_sha256, some_result.archive_sha256);
  EXPECT_EQ(second.ended_at, second.created_at);
  EXPECT_EQ(second.attempt, 0);
}

TEST_F(ResultReuse, FreshMeansComputedAgain) {
  const std::string first = submitted();
  claimed();
  const std::string beside = submitted(true);
  EXPECT_EQ(claimed(), beside);
  store.succeed(first, 1, some_result);
  const std::string behind = submitted(true);
  EXPECT_EQ(job(behind).state, JobState::queued);
  EXPECT_EQ(claimed(), behind);
}

TEST_F(ResultReuse, TwoAtATimeRunOnce) {
  const std::string first = submitted(), second = submitted();
  EXPECT_EQ(claimed(), first);
  const std::string third = submitted();
  EXPECT_FALSE(claimed());
  EXPECT_EQ(job(second).follows, first);
  EXPECT_EQ(job(third).follows, first);
  time.now += 5;
  store.succeed(first, 1, some_result);
  for (const std::string& id : {second, third}) {
    EXPECT_EQ(job(id).state, JobState::succeeded);
    EXPECT_EQ(job(id).result_of, first);
    EXPECT_EQ(job(id).ended_at, time.now);
  }
}

TEST_F(ResultReuse, WhoWaitedForNothingRunsItself) {
  const std::string first = submitted(), second = submitted(), third = submitted();
  claimed();
  EXPECT_FALSE(claimed());
  store.fail(first, 1, "{}");
  EXPECT_EQ(claimed(), second);
  EXPECT_FALSE(claimed());
  store.request_cancel(second);
  store.mark_cancelled(second, 1);
  EXPECT_EQ(claimed(), third);
}

TEST_F(ResultReuse, NobodyWaitsForAPausedOrDeadJob) {
  const std::string first = submitted(), second = submitted();
  claimed();
  EXPECT_FALSE(claimed());
  store.request_pause(first);
  EXPECT_EQ(claimed(), second);
  const std::string third = submitted();
  EXPECT_EQ(job(third).follows, second);
  store.recover("the next one");
  EXPECT_TRUE(store.claim("the next one", lease));
}

TEST_F(ResultReuse, AWaitingJobWhoseResultHasComeNeedNoWorker) {
  const std::string first = submitted(), second = submitted();
  store.request_pause(second);
  claimed();
  store.succeed(first, 1, some_result);
  EXPECT_EQ(job(second).state, JobState::paused);
  store.resume(second);
  bool gave_results = false;
  EXPECT_FALSE(store.claim("me", lease, &gave_results));
  EXPECT_TRUE(gave_results);
  EXPECT_EQ(job(second).result_of, first);
  EXPECT_FALSE(store.claim("me", lease, &gave_results));
  EXPECT_FALSE(gave_results);
}

TEST_F(ResultReuse, AnArchiveStaysAsLongAsOneJobHasIt) {
  const std::string first = submitted();
  claimed();
  store.succeed(first, 1, some_result);
  const std::string second = submitted();
  EXPECT_FALSE(store.remove(first)->archive_id);
  const std::string third = submitted();
  EXPECT_EQ(job(third).archive_id, first);
  EXPECT_EQ(job(third).result_of, first);
  EXPECT_FALSE(store.remove(second)->archive_id);
  EXPECT_EQ(store.remove(third)->archive_id, first);
  EXPECT_EQ(job(submitted()).state, JobState::queued);
}

TEST_F(ResultReuse, WhatATriedAgainRunLeftGoesWithItsJob) {
  const std::string id = submitted();
  claimed();
  store.fail(id, 1, R"({"kind":"engine"})", some_result);
  store.retry(id);
  store.request_cancel(id);
  EXPECT_FALSE(job(id).archive_id);
  EXPECT_EQ(store.remove(id)->archive_id, id);
}

TEST_F(ResultReuse, WhoseResultWasLostComputesItsOwn) {
  const std::string first = submitted();
  claimed();
  store.succeed(first, 1, some_result);
  const std::string second = submitted();
  ASSERT_EQ(job(second).result_of, first);
  SQLite::Database(folder.path() / "jobs.sqlite", SQLite::OPEN_READWRITE)
      .exec(
          "UPDATE jobs SET state = 'failed', error = '{}', summary = NULL, archive_id = NULL, "
          "archive_size = NULL, archive_sha256 = NULL");
  EXPECT_FALSE(store.retry(second)->result_of);
}

class Idempotency : public ResultReuse {
 protected:
  IdempotencyKey key{"lab", "k", std::string(64, '1')};
};

TEST_F(Idempotency, AReplayedKeyGivesTheFirstJob) {
  const Submission first = store.submit(plain_job(), key);
  const Submission again = store.submit(plain_job(), key);
  EXPECT_FALSE(first.replayed);
  EXPECT_TRUE(again.replayed);
  EXPECT_EQ(again.job.id, first.job.id);
  EXPECT_EQ(store.queue_state().counts.at(JobState::queued), 1);
}

TEST_F(Idempotency, EveryCallerHasKeysOfItsOwn) {
  store.submit(plain_job(), key);
  key.caller = "another";
  EXPECT_FALSE(store.submit(plain_job(), key).replayed);
}

TEST_F(Idempotency, AKeyForSomethingElseIsRefused) {
  store.submit(plain_job(), key);
  key.fingerprint = std::string(64, '2');
  EXPECT_THROW(store.submit(plain_job(), key), IdempotencyMismatch);
}

TEST_F(Idempotency, KeysAreForgottenWithTheirJobAndWithTime) {
  const std::string id = store.submit(plain_job(), key).job.id;
  store.request_cancel(id);
  store.remove(id);
  EXPECT_FALSE(store.submit(plain_job(), key).replayed);
  EXPECT_EQ(store.forget_keys(time.now), 0);
  EXPECT_EQ(store.forget_keys(time.now + 1), 1);
  EXPECT_FALSE(store.submit(plain_job(), key).replayed);
}

}  // namespace
}  // namespace rouleau::storage
