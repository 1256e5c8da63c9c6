#include "service/queue/job_logs.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/unit/storage/scratch.h"

namespace rouleau::service {
namespace {

storage::Job some_job() {
  storage::Job job;
  job.id = "a";
  job.name = "two words";
  job.created_at = 1795318393042;
  return job;
}

const std::string accepted = "2026-11-22T03:33:13.042Z event=accepted job=a name=\"two words\" priority=0\n";

TEST(JobLogs, BeginWithTheJobsAcceptance) {
  const storage::ScratchFolder folder;
  JobLogs logs(folder.path() / "logs");
  EXPECT_EQ(logs.read(some_job(), 0), accepted);
  logs.note(some_job(), "started", {{"attempt", "1"}});
  const std::string log = logs.read(some_job(), 0);
  EXPECT_TRUE(log.starts_with(accepted)) << log;
  EXPECT_TRUE(log.ends_with("Z event=started attempt=1\n")) << log;
  EXPECT_EQ(logs.read(some_job(), 5), log.substr(5));
  EXPECT_EQ(logs.read(some_job(), log.size() + 1), "");
}

TEST(JobLogs, SayWhoseResultAJobWasGiven) {
  const storage::ScratchFolder folder;
  JobLogs logs(folder.path());
  storage::Job job = some_job();
  job.state = storage::JobState::succeeded;
  job.result_of = "b";
  job.ended_at = job.created_at;
  EXPECT_EQ(logs.read(job, 0), accepted + "2026-11-22T03:33:13.042Z event=succeeded result_of=b\n");
}

TEST(JobLogs, AnEndBeginsNoLog) {
  const storage::ScratchFolder folder;
  JobLogs logs(folder.path());
  logs.note(some_job(), "started");
  logs.remove("a");
  logs.note_end(some_job(), "succeeded");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(JobLogs, AreBoundedAndKeepRoomForTheEnd) {
  const storage::ScratchFolder folder;
  JobLogs logs(folder.path());
  const std::string kilobyte(1000, 'x');
  for (int k = 0; k < 1000; ++k) logs.note_routine(some_job(), "checkpoint", {{"text", kilobyte}});
  EXPECT_LE(std::filesystem::file_size(folder.path() / "a.log"), JobLogs::routine_until);
  logs.note_end(some_job(), "succeeded");
  EXPECT_TRUE(logs.read(some_job(), 0).ends_with("event=succeeded\n"));
  for (int k = 0; k < 1000; ++k) logs.note(some_job(), "paused", {{"text", kilobyte}});
  EXPECT_LE(std::filesystem::file_size(folder.path() / "a.log"), JobLogs::largest);
}

TEST(JobLogs, ThatCannotBeWrittenStopNobody) {
  const storage::ScratchFolder folder;
  JobLogs logs(folder.path() / "logs");
  std::filesystem::remove_all(folder.path() / "logs");
  logs.note(some_job(), "started");
  EXPECT_EQ(logs.read(some_job(), 0), accepted);
}

}  // namespace
}  // namespace rouleau::service
