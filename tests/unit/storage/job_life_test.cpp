#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

class JobLife : public testing::Test {
 protected:
  static constexpr std::chrono::seconds lease{10};

  std::string submitted() { return store.submit(plain_job()).job.id; }
  std::string running() {
    const std::string id = submitted();
    EXPECT_EQ(store.claim("me", lease)->job.id, id);
    return id;
  }
  Job job(const std::string& id) { return store.find(id).value(); }
  void expect_refused(std::optional<Job> (JobStore::*request)(std::string_view), const std::string& id) {
    EXPECT_THROW((store.*request)(id), InvalidTransition) << to_string(job(id).state);
  }

  ScratchFolder folder;
  BentClock time;
  JobStore store{folder.path(), time.clock()};
};

TEST_F(JobLife, APausedJobWaitsUntilItIsResumed) {
  const std::string id = submitted();
  EXPECT_EQ(store.request_pause(id)->state, JobState::paused);
  EXPECT_EQ(store.request_pause(id)->state, JobState::paused) << "asking again changes nothing";
  EXPECT_FALSE(store.claim("me", lease));
  EXPECT_EQ(store.resume(id)->state, JobState::queued);
  EXPECT_EQ(store.claim("me", lease)->job.id, id);
}

TEST_F(JobLife, ARunningJobIsPausedOnceItsWorkerLetsGo) {
  const std::string id = running();
  store.renew(id, 1, lease, R"({"fraction":0.5})");
  const Job asked = store.request_pause(id).value();
  EXPECT_EQ(asked.state, JobState::running);
  EXPECT_TRUE(asked.pause_requested);
  EXPECT_EQ(store.renew(id, 1, lease), Lease::pause_requested);
  EXPECT_TRUE(store.release(id, 1));
  const Job paused = job(id);
  EXPECT_EQ(paused.state, JobState::paused);
  EXPECT_FALSE(paused.pause_requested);
  EXPECT_EQ(paused.progress, R"({"fraction":0.5})") << "what it has computed is not forgotten";
  EXPECT_EQ(paused.setbacks, 0);
}

TEST_F(JobLife, AJobThatWasToPauseIsPausedAfterACrash) {
  const std::string id = running();
  store.request_pause(id);
  EXPECT_EQ(store.recover("the next one"), 1);
  EXPECT_EQ(job(id).state, JobState::paused);
}

TEST_F(JobLife, ResumingTakesBackAPauseThatIsOnItsWay) {
  const std::string id = running();
  store.request_pause(id);
  EXPECT_EQ(store.resume(id)->state, JobState::running);
  EXPECT_EQ(store.renew(id, 1, lease), Lease::held);
  store.release(id, 1);
  EXPECT_EQ(job(id).state, JobState::queued);
}

TEST_F(JobLife, ARunThatEndsBeforeItsPauseKeepsItsEnd) {
  const std::string id = running();
  store.request_pause(id);
  EXPECT_TRUE(store.succeed(id, 1, some_result));
  EXPECT_EQ(job(id).state, JobState::succeeded);
}

TEST_F(JobLife, CancellingGoesBeforePausing) {
  const std::string id = running();
  store.request_pause(id);
  EXPECT_EQ(store.request_cancel(id)->state, JobState::cancelling);
  expect_refused(&JobStore::request_pause, id);
  const std::string waiting = submitted();
  store.request_pause(waiting);
  EXPECT_EQ(store.request_cancel(waiting)->state, JobState::cancelled);
}

TEST_F(JobLife, WhatFailedOrWasCancelledIsTriedAgain) {
  const std::string failed = running();
  store.fail(failed, 1, "{}", some_result);
  const Job again = store.retry(failed).value();
  EXPECT_EQ(again.state, JobState::queued);
  EXPECT_FALSE(again.error || again.summary || again.archive_id || again.ended_at || again.started_at);
  EXPECT_EQ(store.claim("me", lease)->job.attempt, 2);
  EXPECT_TRUE(store.succeed(failed, 2, some_result));
  expect_refused(&JobStore::retry, failed);

  const std::string cancelled = submitted();
  store.request_cancel(cancelled);
  EXPECT_EQ(store.retry(cancelled)->state, JobState::queued);
  expect_refused(&JobStore::retry, cancelled);
  EXPECT_FALSE(store.retry("no such job"));
}

TEST_F(JobLife, AttemptsThatDieAreCountedUntilOneLeavesACheckpoint) {
  const std::string id = running();
  store.recover("second");
  EXPECT_EQ(job(id).setbacks, 1);
  store.claim("second", lease);
  time.now += 10'001;
  store.expire_leases();
  EXPECT_EQ(job(id).setbacks, 2);
  store.claim("third", lease);
  store.release(id, 3);
  EXPECT_EQ(job(id).setbacks, 2) << "given back in good order";
  store.claim("third", lease);
  EXPECT_TRUE(store.note_checkpoint(id, 4));
  EXPECT_FALSE(store.note_checkpoint(id, 3));
  EXPECT_EQ(job(id).setbacks, 0);
  store.release(id, 4, time.now + 5);
  EXPECT_EQ(job(id).setbacks, 1) << "to be tried again later";
}

TEST_F(JobLife, OnlyWhatHasEndedIsRemoved) {
  const std::string id = running();
  EXPECT_THROW(store.remove(id), InvalidTransition);
  store.succeed(id, 1, some_result);
  EXPECT_EQ(store.remove(id)->archive_id, id);
  EXPECT_FALSE(store.find(id) || store.case_text(id) || store.remove(id));
  EXPECT_FALSE(store.has_expired(id));
}

TEST_F(JobLife, WhatMadeRoomIsRemembered) {
  const std::string id = submitted();
  store.request_cancel(id);
  EXPECT_EQ(store.remove(id, JobStore::Removal::expired)->archive_id, id)
      << "an earlier attempt may have left it";
  EXPECT_TRUE(store.has_expired(id));
}

TEST_F(JobLife, NothingIsClaimedFromAPausedQueueAlsoAfterARestart) {
  const ScratchFolder other;
  {
    JobStore first(other.path());
    first.submit(plain_job());
    first.pause_queue(true);
  }
  JobStore second(other.path());
  EXPECT_TRUE(second.queue_state().paused);
  EXPECT_FALSE(second.claim("me", lease));
  second.pause_queue(false);
  EXPECT_TRUE(second.claim("me", lease));
}

TEST_F(JobLife, LanesTakeTurnsWithinAPriority) {
  const auto submit = [&](const std::string& lane, int priority = 0) {
    NewJob wanted = plain_job(lane, priority);
    wanted.lane = lane;
    store.submit(wanted);
  };
  for (int i = 0; i < 4; ++i) submit("busy");
  submit("second");
  submit("third");
  submit("urgent", 1);
  std::string order;
  while (const auto claimed = store.claim("me", lease)) order += claimed->job.lane + " ";
  EXPECT_EQ(order, "urgent busy second third busy busy busy ");
  submit("busy");
  submit("new");
  EXPECT_EQ(store.claim("me", lease)->job.lane, "new") << "served longest ago, for never";
}

}  // namespace
}  // namespace rouleau::storage
