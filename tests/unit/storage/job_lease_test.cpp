#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

using std::chrono::seconds;

class JobLease : public testing::Test {
 protected:
  Job submitted(const std::string& name = "plain", int priority = 0) {
    return store.submit(plain_job(name, priority)).job;
  }
  Job claimed() { return store.claim("me", seconds(10)).value().job; }
  JobState state(const std::string& id) { return store.find(id).value().state; }

  ScratchFolder folder;
  BentClock time;
  JobStore store{folder.path(), time.clock()};
};

TEST_F(JobLease, ClaimsByPriorityThenAge) {
  submitted("old low", -1);
  submitted("old");
  submitted("young");
  submitted("urgent", 5);
  std::vector<std::string> order;
  while (const auto claim = store.claim("me", seconds(10))) order.push_back(claim->job.name);
  EXPECT_EQ(order, (std::vector<std::string>{"urgent", "old", "young", "old low"}));
}

TEST_F(JobLease, AClaimCarriesTheCaseAndCountsTheAttempt) {
  const NewJob job = plain_job("x");
  const std::string id = store.submit(job).job.id;
  time.now += 500;
  const auto claim = store.claim("me", seconds(10));
  ASSERT_TRUE(claim);
  EXPECT_EQ(claim->job.id, id);
  EXPECT_EQ(claim->job.state, JobState::running);
  EXPECT_EQ(claim->job.attempt, 1);
  EXPECT_EQ(claim->job.started_at, time.now);
  EXPECT_EQ(claim->text.resolved, job.case_resolved);
  EXPECT_EQ(claim->text.given, job.case_given);
}

TEST_F(JobLease, EightWorkersNeverClaimOneJobTwice) {
  for (int i = 0; i < 40; ++i) submitted();
  std::vector<std::thread> workers;
  std::atomic<int> claims = 0;
  for (int i = 0; i < 8; ++i) {
    workers.emplace_back([&] {
      while (const auto claim = store.claim("me", seconds(10))) {
        EXPECT_EQ(claim->job.attempt, 1);
        ++claims;
      }
    });
  }
  for (auto& worker : workers) worker.join();
  EXPECT_EQ(claims, 40);
}

TEST_F(JobLease, SuccessIsKept) {
  submitted();
  const Job job = claimed();
  time.now += 1000;
  EXPECT_TRUE(store.succeed(job.id, 1, some_result));
  const Job ended = store.find(job.id).value();
  EXPECT_EQ(ended.state, JobState::succeeded);
  EXPECT_EQ(ended.ended_at, time.now);
  EXPECT_EQ(ended.summary, R"({"ending":"completed"})");
  EXPECT_EQ(ended.archive_size, 1234);
  EXPECT_EQ(ended.archive_sha256, some_result.archive_sha256);
  EXPECT_FALSE(store.succeed(job.id, 1, some_result)) << "an ended job ended again";
  EXPECT_FALSE(store.fail(job.id, 1, "{}"));
  EXPECT_FALSE(store.release(job.id, 1));
}

TEST_F(JobLease, FailureKeepsItsError) {
  submitted();
  const Job job = claimed();
  EXPECT_TRUE(store.fail(job.id, 1, R"({"kind":"engine"})"));
  const Job ended = store.find(job.id).value();
  EXPECT_EQ(ended.state, JobState::failed);
  EXPECT_EQ(ended.error, R"({"kind":"engine"})");
  EXPECT_EQ(ended.ended_at, time.now);
  EXPECT_FALSE(ended.summary || ended.archive_size || ended.archive_sha256);
}

TEST_F(JobLease, FailureKeepsWhatTheRunLeft) {
  submitted();
  const Job job = claimed();
  EXPECT_TRUE(store.fail(job.id, 1, R"({"kind":"engine"})", JobResult{"{}", 12, some_result.archive_sha256}));
  const Job ended = store.find(job.id).value();
  EXPECT_EQ(ended.state, JobState::failed);
  EXPECT_EQ(ended.error, R"({"kind":"engine"})");
  EXPECT_EQ(ended.summary, "{}");
  EXPECT_EQ(ended.archive_size, 12);
  EXPECT_EQ(ended.archive_sha256, some_result.archive_sha256);
}

TEST_F(JobLease, RenewingHoldsTheJobAndStoresProgress) {
  submitted();
  const Job job = claimed();
  for (int i = 0; i < 5; ++i) {
    time.now += 9000;
    EXPECT_EQ(store.renew(job.id, 1, seconds(10), R"({"fraction":0.5})"), Lease::held);
    EXPECT_EQ(store.expire_leases(), 0);
  }
  EXPECT_EQ(store.renew(job.id, 1, seconds(10)), Lease::held);
  EXPECT_EQ(store.find(job.id)->progress, R"({"fraction":0.5})") << "a renewal without progress keeps it";
}

TEST_F(JobLease, AnExpiredLeaseLetsAnotherWorkerInAndFencesTheFirst) {
  submitted();
  const Job first = claimed();
  store.renew(first.id, 1, seconds(10), R"({"fraction":0.5})");
  time.now += 10'001;
  EXPECT_EQ(store.expire_leases(), 1);
  EXPECT_EQ(state(first.id), JobState::queued);
  EXPECT_TRUE(store.find(first.id)->progress) << "how far it came, and may go on from";
  EXPECT_EQ(store.renew(first.id, 1, seconds(10)), Lease::lost);

  const Job second = claimed();
  EXPECT_EQ(second.id, first.id);
  EXPECT_EQ(second.attempt, 2);
  EXPECT_EQ(store.renew(first.id, 1, seconds(10)), Lease::lost);
  EXPECT_FALSE(store.succeed(first.id, 1, some_result));
  EXPECT_FALSE(store.fail(first.id, 1, "{}"));
  EXPECT_FALSE(store.release(first.id, 1));
  EXPECT_EQ(state(first.id), JobState::running);
  EXPECT_TRUE(store.succeed(first.id, 2, some_result));
}

TEST_F(JobLease, ReleasedJobsWaitUntilTheirTime) {
  submitted();
  const Job job = claimed();
  EXPECT_TRUE(store.release(job.id, 1, time.now + 5000));
  EXPECT_EQ(state(job.id), JobState::queued);
  EXPECT_FALSE(store.find(job.id)->started_at);
  EXPECT_FALSE(store.claim("me", seconds(10)));
  time.now += 5000;
  EXPECT_EQ(claimed().attempt, 2);
  EXPECT_FALSE(store.find(job.id)->not_before);
}

TEST_F(JobLease, ReleasedJobsDoNotWaitForAClockThatSteppedBack) {
  submitted();
  const Job job = claimed();
  EXPECT_TRUE(store.release(job.id, 1, time.now + 5000));
  time.now -= 24 * 3'600'000;
  EXPECT_EQ(claimed().attempt, 2);
  EXPECT_EQ(store.renew(job.id, 2, seconds(10)), Lease::held);
  EXPECT_EQ(store.expire_leases(), 0);
  const Job later = submitted();
  EXPECT_GT(later.id, job.id);
  EXPECT_LT(later.created_at, job.created_at);
}

TEST_F(JobLease, CancellingAWaitingJobEndsIt) {
  const Job job = submitted();
  EXPECT_EQ(store.request_cancel(job.id)->state, JobState::cancelled);
  EXPECT_EQ(store.request_cancel(job.id)->state, JobState::cancelled) << "again changes nothing";
  EXPECT_EQ(store.find(job.id)->ended_at, time.now);
  EXPECT_FALSE(store.claim("me", seconds(10)));
}

TEST_F(JobLease, CancellingAJobThatWaitsForItsTimeEndsIt) {
  submitted();
  const Job job = claimed();
  store.release(job.id, 1, time.now + 5000);
  EXPECT_EQ(store.request_cancel(job.id)->state, JobState::cancelled);
}

TEST_F(JobLease, CancellingARunningJobReachesItsWorker) {
  submitted();
  const Job job = claimed();
  EXPECT_FALSE(store.mark_cancelled(job.id, 1)) << "nobody asked for it";
  EXPECT_EQ(store.request_cancel(job.id)->state, JobState::cancelling);
  EXPECT_EQ(store.request_cancel(job.id)->state, JobState::cancelling);
  EXPECT_EQ(store.renew(job.id, 1, seconds(10)), Lease::cancel_requested);
  EXPECT_FALSE(store.mark_cancelled(job.id, 2)) << "another attempt's";
  EXPECT_TRUE(store.mark_cancelled(job.id, 1));
  EXPECT_EQ(state(job.id), JobState::cancelled);
}

TEST_F(JobLease, ARunThatEndsBeforeItsCancellationKeepsItsEnd) {
  submitted();
  const Job job = claimed();
  store.request_cancel(job.id);
  EXPECT_TRUE(store.succeed(job.id, 1, some_result));
  EXPECT_EQ(state(job.id), JobState::succeeded);
}

TEST_F(JobLease, CancellingWhatHasEndedIsRefused) {
  EXPECT_FALSE(store.request_cancel("no such job"));
  submitted();
  const Job job = claimed();
  store.fail(job.id, 1, "{}");
  try {
    store.request_cancel(job.id);
    FAIL();
  } catch (const InvalidTransition& refused) {
    EXPECT_EQ(refused.state(), JobState::failed);
  }
}

TEST_F(JobLease, AJobBeingCancelledDoesNotComeBack) {
  for (int i = 0; i < 3; ++i) {
    submitted();
    const Job job = claimed();
    store.request_cancel(job.id);
    time.now += 10'001;
    const int given_back = i == 0   ? store.release(job.id, 1, time.now + 5)
                           : i == 1 ? store.recover("the next one")
                                    : store.expire_leases();
    EXPECT_EQ(given_back, 1) << i;
    EXPECT_EQ(state(job.id), JobState::cancelled) << i;
    EXPECT_EQ(store.find(job.id)->ended_at, time.now);
  }
}

TEST_F(JobLease, RecoveryTakesBackWhatOthersHeldAtOnce) {
  submitted("theirs");
  submitted("mine");
  const Job theirs = store.claim("dead", seconds(1000)).value().job;
  const Job mine = store.claim("me", seconds(1000)).value().job;
  EXPECT_EQ(store.recover("me"), 1);
  EXPECT_EQ(state(theirs.id), JobState::queued);
  EXPECT_EQ(state(mine.id), JobState::running);
  EXPECT_EQ(store.recover("me"), 0);
}

}  // namespace
}  // namespace rouleau::storage
