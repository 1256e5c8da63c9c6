#include "service/queue/live_job.h"

#include <array>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "service/queue/live_jobs.h"

namespace rouleau::service {
namespace {

RunHeader header_of_two_cells() {
  RunHeader header;
  header.columns = {{"time", "s"}, {"cell0.u", "m/s"}};
  header.nodes_per_cell = {3, 2};
  header.membrane_fields = {{"strain", "1"}};
  return header;
}

Frame frame_at(double time) {
  Frame frame;
  frame.time = time;
  frame.kind.assign(5, ParticleKind::membrane);
  frame.kind.push_back(ParticleKind::plasma);
  frame.cell = {0, 0, 0, 1, 1, -1};
  frame.x = {0, 1, 2, 10, 11, 50};
  frame.y = {5, 6, 7, 15, 16, 50};
  frame.membrane_fields = {{0.1F, 0.2F, 0.3F, 0.4F, 0.5F}};
  return frame;
}

TEST(LiveJob, ShowsWhatTheRunDelivered) {
  LiveJob job("id", 1);
  EXPECT_TRUE(job.series().columns.empty());
  EXPECT_FALSE(job.progress());

  job.begin(header_of_two_cells());
  job.series_row(std::array{0.0, 1.0});
  job.series_row(std::array{0.5, 2.0});
  job.frame(frame_at(0));
  job.frame(frame_at(0.5));

  EXPECT_EQ(job.series().values, (std::vector<std::vector<double>>{{0, 0.5}, {1, 2}}));
  EXPECT_EQ(job.frame_times(), (std::vector<double>{0, 0.5}));
  const auto outlines = job.outlines(1);
  ASSERT_TRUE(outlines);
  ASSERT_EQ(outlines->size(), 2u);
  EXPECT_EQ((*outlines)[0].x, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ((*outlines)[1].y, (std::vector<float>{15, 16}));
  EXPECT_EQ((*outlines)[1].fields.at("strain"), (std::vector<float>{0.4F, 0.5F}));
  EXPECT_FALSE(job.outlines(2));
  EXPECT_FALSE(job.outlines(-1));
  EXPECT_EQ(job.last_frame()->time, 0.5);
}

TEST(LiveJob, GivesTheRowsFromOneOn) {
  LiveJob job("id", 1);
  EXPECT_TRUE(job.series(0, 10).values.empty());
  job.begin(header_of_two_cells());
  for (const double time : {0.0, 0.5, 1.0}) job.series_row(std::array{time, 2 * time});
  EXPECT_EQ(job.series(1, 1).values, (std::vector<std::vector<double>>{{0.5}, {1}}));
  EXPECT_EQ(job.series(2, 10).values, (std::vector<std::vector<double>>{{1}, {2}}));
  EXPECT_EQ(job.series(9, 10).values, (std::vector<std::vector<double>>{{}, {}}));
}

TEST(LiveJob, ForgetsWhatIsDeliveredAgain) {
  LiveJob job("id", 1);
  job.begin(header_of_two_cells());
  job.series_row(std::array{0.0, 1.0});
  job.frame(frame_at(0));
  job.begin(header_of_two_cells());
  EXPECT_TRUE(job.frame_times().empty());
  EXPECT_FALSE(job.last_frame());
  EXPECT_TRUE(job.series().values.at(0).empty());
}

TEST(LiveJob, ACellThatHasLeftHasAnEmptyOutline) {
  LiveJob job("id", 1);
  job.begin(header_of_two_cells());
  Frame frame = frame_at(0);
  for (auto* numbers : {&frame.x, &frame.y}) numbers->erase(numbers->begin(), numbers->begin() + 3);
  frame.kind.erase(frame.kind.begin(), frame.kind.begin() + 3);
  frame.cell.erase(frame.cell.begin(), frame.cell.begin() + 3);
  frame.membrane_fields = {{0.4F, 0.5F}};
  job.frame(frame);
  const auto outlines = job.outlines(0);
  ASSERT_TRUE(outlines);
  ASSERT_EQ(outlines->size(), 2u);
  EXPECT_TRUE((*outlines)[0].x.empty());
  EXPECT_EQ((*outlines)[1].x, (std::vector<float>{10, 11}));
}

TEST(LiveJob, StopsForTheFirstReasonGiven) {
  LiveJob job("id", 1);
  EXPECT_FALSE(job.stop_token().stop_requested());
  job.stop(StopReason::cancelled);
  job.stop(StopReason::draining);
  EXPECT_TRUE(job.stop_token().stop_requested());
  EXPECT_EQ(job.stop_reason(), StopReason::cancelled);
}

TEST(LiveJobs, WaitsForTheEndOfAnAttempt) {
  LiveJobs jobs;
  EXPECT_TRUE(jobs.wait_until_ended("1", std::chrono::milliseconds(0)));
  const auto job = jobs.start("1", 1);
  EXPECT_FALSE(jobs.wait_until_ended("1", std::chrono::milliseconds(1)));
  std::thread other([&] { jobs.end(job, true); });
  EXPECT_TRUE(jobs.wait_until_ended("1", std::chrono::minutes(1)));
  other.join();
  jobs.forget("1");
  EXPECT_EQ(jobs.find("1"), nullptr);
}

TEST(LiveJobs, KeepsTheLastOnesThatLeftNoArchive) {
  LiveJobs jobs;
  for (int i = 0; i < 20; ++i) jobs.end(jobs.start(std::to_string(i), 1), true);
  EXPECT_TRUE(jobs.running().empty());
  EXPECT_EQ(jobs.find("3"), nullptr);
  ASSERT_NE(jobs.find("4"), nullptr);

  const auto again = jobs.start("4", 2);
  EXPECT_EQ(jobs.find("4"), again);
  jobs.end(again, false);
  EXPECT_EQ(jobs.find("4"), nullptr);
}

}  // namespace
}  // namespace rouleau::service
