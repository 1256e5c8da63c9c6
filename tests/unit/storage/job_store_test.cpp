#include "storage/job_store.h"

#include <algorithm>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "storage/sha256.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

TEST(JobStore, GivesBackWhatWasSubmitted) {
  const ScratchFolder folder;
  BentClock time;
  JobStore store(folder.path(), time.clock());
  NewJob submitted = plain_job("first", 3);
  submitted.labels = R"({"lab":"A"})";
  const Job job = store.submit(submitted).job;

  const auto found = store.find(job.id);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, job.id);
  EXPECT_EQ(found->state, JobState::queued);
  EXPECT_EQ(found->name, "first");
  EXPECT_EQ(found->case_hash, submitted.case_hash);
  EXPECT_EQ(found->labels, submitted.labels);
  EXPECT_EQ(found->priority, 3);
  EXPECT_EQ(found->attempt, 0);
  EXPECT_EQ(found->created_at, time.now);
  EXPECT_EQ(found->plan, submitted.plan);
  EXPECT_FALSE(found->started_at || found->ended_at || found->progress || found->summary || found->error);
  const auto text = store.case_text(job.id);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->given, submitted.case_given);
  EXPECT_EQ(text->resolved, submitted.case_resolved);
  EXPECT_FALSE(store.find("no such job"));
}

TEST(JobStore, KeepsJobsFromOneRunToTheNext) {
  const ScratchFolder folder;
  std::string id;
  {
    JobStore store(folder.path());
    id = store.submit(plain_job()).job.id;
  }
  JobStore store(folder.path());
  EXPECT_TRUE(store.find(id));
}

TEST(JobStore, IdsRiseEvenIfTheClockStepsBackBetweenRuns) {
  const ScratchFolder folder;
  BentClock time;
  std::string earlier;
  {
    JobStore store(folder.path(), time.clock());
    earlier = store.submit(plain_job()).job.id;
  }
  time.now -= 3'600'000;
  JobStore store(folder.path(), time.clock());
  EXPECT_GT(store.submit(plain_job()).job.id, earlier);
}

TEST(JobStore, CountsEveryState) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  store.submit(plain_job());
  store.submit(plain_job());
  store.request_cancel(store.submit(plain_job()).job.id);
  const auto counts = store.queue_state().counts;
  EXPECT_EQ(counts.size(), all_job_states.size());
  EXPECT_EQ(counts.at(JobState::queued), 2);
  EXPECT_EQ(counts.at(JobState::cancelled), 1);
  EXPECT_EQ(counts.at(JobState::running), 0);
}

TEST(JobStore, RefusesTextsThatAreNoJson) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  NewJob bad_labels = plain_job();
  bad_labels.labels = "[1]";
  NewJob bad_plan = plain_job();
  bad_plan.plan = "{";
  for (const NewJob& bad : {bad_labels, bad_plan}) {
    try {
      store.submit(bad);
      FAIL() << "stored " << bad.labels << bad.plan;
    } catch (const StoreError& error) {
      EXPECT_EQ(error.kind(), StoreError::Kind::invalid_argument);
    }
  }
  EXPECT_EQ(store.queue_state().counts.at(JobState::queued), 0);
}

TEST(JobStore, StoresHostileTextAsText) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  const std::string name = "'); DROP TABLE jobs; --\n\xc3\xa9\xf0\x9f\xa9\xb8";
  NewJob job = plain_job();
  job.name = name;
  job.labels = R"({"a\"b$.c":"x' OR 1=1"})";
  const std::string id = store.submit(job).job.id;
  EXPECT_EQ(store.find(id)->name, name);
  EXPECT_EQ(store.list({.labels = {{"a\"b$.c", "x' OR 1=1"}}}).jobs.size(), 1u);
  EXPECT_TRUE(store.list({.labels = {{"a\"b$.c", "x"}}}).jobs.empty());
}

TEST(JobStore, ListsByStateAndLabels) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  NewJob a = plain_job("a");
  a.labels = R"({"lab":"A","run":"1"})";
  NewJob b = plain_job("b");
  b.labels = R"({"lab":"B","run":"1"})";
  store.submit(a);
  store.submit(b);
  store.submit(plain_job("c"));
  store.claim("me", std::chrono::seconds(10));  // a, the oldest

  const auto names = [&](const JobQuery& query) {
    std::vector<std::string> found;
    for (const Job& job : store.list(query).jobs) found.push_back(job.name);
    return found;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({}), (Names{"c", "b", "a"}));
  EXPECT_EQ(names({.states = {JobState::running}}), (Names{"a"}));
  EXPECT_EQ(names({.states = {JobState::running, JobState::queued}}), (Names{"c", "b", "a"}));
  EXPECT_EQ(names({.labels = {{"run", "1"}}}), (Names{"b", "a"}));
  EXPECT_EQ(names({.labels = {{"run", "1"}, {"lab", "B"}}}), (Names{"b"}));
  EXPECT_EQ(names({.states = {JobState::queued}, .labels = {{"lab", "A"}}}), (Names{}));
}

TEST(JobStore, PagesShowEachJobOnceWhileOthersAreSubmitted) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  std::vector<std::string> before;
  for (int i = 0; i < 25; ++i) before.push_back(store.submit(plain_job()).job.id);

  std::vector<std::string> seen;
  JobQuery query{.page_size = 10};
  int pages = 0;
  while (true) {
    const JobPage page = store.list(query);
    ++pages;
    for (const Job& job : page.jobs) seen.push_back(job.id);
    if (!page.next_page_token) break;
    query.page_token = *page.next_page_token;
    for (int i = 0; i < 3; ++i) store.submit(plain_job());
  }
  EXPECT_EQ(pages, 3);
  EXPECT_EQ(seen, std::vector<std::string>(before.rbegin(), before.rend()));
}

TEST(JobStore, APageThatHoldsAllHasNoNext) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  EXPECT_FALSE(store.list({}).next_page_token);
  for (int i = 0; i < 10; ++i) store.submit(plain_job());
  EXPECT_FALSE(store.list({.page_size = 10}).next_page_token);
  EXPECT_TRUE(store.list({.page_size = 9}).next_page_token);
  EXPECT_EQ(store.list({.page_size = -5}).jobs.size(), 1u);
}

TEST(JobStore, RefusesAPageTokenOfAnothersMaking) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  EXPECT_THROW(store.list({.page_token = "2"}), StoreError);
  EXPECT_THROW(store.list({.page_token = std::string(36, 'z')}), StoreError);
}

TEST(JobStore, EightThreadsSubmitAndReadAtOnce) {
  const ScratchFolder folder;
  JobStore store(folder.path());
  constexpr int each = 25;
  std::vector<std::thread> threads;
  std::vector<std::vector<std::string>> ids(8);
  for (auto& mine : ids) {
    threads.emplace_back([&] {
      for (int i = 0; i < each; ++i) {
        mine.push_back(store.submit(plain_job()).job.id);
        if (!store.find(mine.back())) mine.clear();  // answered, yet not there
      }
    });
  }
  for (auto& thread : threads) thread.join();
  std::set<std::string> distinct;
  for (const auto& mine : ids) {
    EXPECT_EQ(mine.size(), static_cast<std::size_t>(each));
    EXPECT_TRUE(std::is_sorted(mine.begin(), mine.end()));
    distinct.insert(mine.begin(), mine.end());
  }
  EXPECT_EQ(distinct.size(), 8u * each);
  EXPECT_EQ(store.queue_state().counts.at(JobState::queued), 8 * each);
}

}  // namespace
}  // namespace rouleau::storage
