#include "service/queue/attempt.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "storage/archive_reader.h"
#include "storage/checkpoint_file.h"
#include "storage/sha256.h"

namespace rouleau::service {
namespace {

using storage::JobState;

constexpr const char* short_case =
    R"({"version": 1, "vessel": {"length": 20e-6, "diameter": 10e-6}, "numerics": {"preset": "draft"},
        "duration": 5e-5})";

/// A limp cell that walls drag apart until the particles inside cannot carry it, after some 300 steps.
constexpr const char* unstable_case =
    R"({"version": 1, "numerics": {"preset": "draft", "refine": "off"}, "duration": 3e-3,
        "plasma": {"kinematic_viscosity": 1e-5},
        "vessel": {"length": 20e-6, "diameter": 10e-6, "ends": "periodic",
                   "wall_velocity": {"lower": -0.05, "upper": 0.05}},
        "cells": [{"x": 10e-6, "y": 5e-6, "diameter": 6e-6, "fill": 1, "shape": "circle",
                   "stretch_modulus": 1e-9, "bend_modulus": 1e-20}]})";

/// A real store with one job in it.
class AttemptAtAJob : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(archives_);
    store_.emplace(folder_ / "data");
    logs_.emplace(folder_ / "logs");
    place_.emplace(*store_, live_, *logs_, machine_, archives_);
    // However slow the machine is.
    place_->checkpoint_interval = std::chrono::hours(1);
    id_ = submit(short_case);
  }
  void TearDown() override {
    place_.reset();
    store_.reset();
    std::filesystem::remove_all(folder_);
  }

  std::string submit(const std::string& text) {
    storage::NewJob job;
    job.case_given = job.case_resolved = text;
    job.plan = "{}";
    job.case_hash = storage::sha256_hex(text);
    job.fresh = true;
    return store_->submit(job).job.id;
  }
  Attempt begin() { return {place_.value(), store_->claim("test", lease_time).value()}; }
  storage::Job job() { return store_->find(id_).value(); }
  std::string log() { return logs_->read(job(), 0); }
  /// What an attempt leaves that is stopped before its first step.
  void stop_at_once(StopReason reason) {
    Attempt attempt = begin();
    live_.find(id_)->stop(reason);
    attempt.run();
  }
  bool has_files() const { return !std::filesystem::is_empty(archives_); }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("attempt_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  std::filesystem::path archives_ = folder_ / "archives";
  std::optional<storage::JobStore> store_;
  KnownMachine machine_{folder_};
  std::optional<JobLogs> logs_;
  LiveJobs live_;
  std::optional<Workplace> place_;
  std::string id_;
};

TEST_F(AttemptAtAJob, PublishesAnArchive) {
  begin().run();
  const auto ended = job();
  EXPECT_EQ(ended.state, JobState::succeeded);
  EXPECT_EQ(storage::sha256_hex_of_file(archive_path(archives_, id_)), ended.archive_sha256);
  EXPECT_EQ(nlohmann::json::parse(*ended.summary)["ending"], "completed");
  EXPECT_TRUE(live_.running().empty());
}

TEST_F(AttemptAtAJob, TakesTheArchiveOfAnAttemptThatDiedJustBeforeItsEnd) {
  begin().run();
  const storage::Job first = job();
  const std::string twin = submit(short_case);
  std::filesystem::rename(archive_path(archives_, id_), archive_path(archives_, twin));
  id_ = twin;
  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_EQ(job().archive_sha256, first.archive_sha256) << "another run would have taken another time";
  EXPECT_NE(log().find("had ended already"), std::string::npos) << log();
}

TEST_F(AttemptAtAJob, RunsIfTheArchiveInItsPlaceIsAnotherCases) {
  begin().run();
  const std::string other = submit(R"({"version": 1, "vessel": {"length": 20e-6, "diameter": 10e-6},
                                       "numerics": {"preset": "draft"}, "duration": 1e-5})");
  std::filesystem::rename(archive_path(archives_, id_), archive_path(archives_, other));
  id_ = other;
  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_EQ(log().find("had ended already"), std::string::npos) << log();
}

TEST_F(AttemptAtAJob, PublishesNothingOnceItsLeaseIsLost) {
  Attempt attempt = begin();
  ASSERT_TRUE(store_->release(id_, 1));
  attempt.run();
  EXPECT_EQ(job().state, JobState::queued);
  EXPECT_FALSE(has_files());

  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_EQ(job().attempt, 2);
}

TEST_F(AttemptAtAJob, IsCancelledInMidRun) {
  Attempt attempt = begin();
  store_->request_cancel(id_);
  live_.find(id_)->stop(StopReason::cancelled);
  attempt.run();
  EXPECT_EQ(job().state, JobState::cancelled);
  EXPECT_FALSE(has_files());
  EXPECT_NE(live_.find(id_), nullptr) << "what it had is kept a while";
}

TEST_F(AttemptAtAJob, GivesTheJobBackWhenItDrains) {
  Attempt attempt = begin();
  live_.find(id_)->stop(StopReason::draining);
  attempt.run();
  EXPECT_EQ(job().state, JobState::queued);
  EXPECT_FALSE(job().not_before);
}

TEST_F(AttemptAtAJob, PausesAtACheckpointAndGoesOnFromIt) {
  Attempt attempt = begin();
  store_->request_pause(id_);
  live_.find(id_)->stop(StopReason::paused);
  attempt.run();
  EXPECT_EQ(job().state, JobState::paused);
  EXPECT_TRUE(std::filesystem::exists(storage::checkpoint_path(archive_path(archives_, id_))));
  EXPECT_FALSE(unfinished_archive(archives_, id_).empty());

  store_->resume(id_);
  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_NE(log().find("event=\"goes on\" step=0"), std::string::npos) << log();
  EXPECT_TRUE(unfinished_archive(archives_, id_).empty());
}

TEST_F(AttemptAtAJob, IsCancelledThoughItWasToldToPauseFirst) {
  Attempt attempt = begin();
  live_.find(id_)->stop(StopReason::paused);
  store_->request_cancel(id_);
  attempt.run();
  EXPECT_EQ(job().state, JobState::cancelled);
  EXPECT_FALSE(has_files());
}

TEST_F(AttemptAtAJob, BeginsAnewIfItsCheckpointIsDamaged) {
  stop_at_once(StopReason::draining);
  std::ofstream(storage::checkpoint_path(archive_path(archives_, id_)), std::ios::app) << "more";
  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_NE(log().find("event=\"begins anew\""), std::string::npos) << log();
}

TEST_F(AttemptAtAJob, BeginsAnewIfItKeepsDyingOfItsCheckpoint) {
  stop_at_once(StopReason::draining);
  for (int k = 0; k < setbacks_until_anew; ++k) {
    const auto claimed = store_->claim("test", lease_time).value();
    ASSERT_TRUE(store_->release(id_, claimed.job.attempt, 0));
  }
  begin().run();
  EXPECT_EQ(job().state, JobState::succeeded);
  EXPECT_NE(log().find("attempts died"), std::string::npos) << log();
}

TEST_F(AttemptAtAJob, IsTheLastOfTooManyInARowThatDied) {
  for (int k = 0; k < most_setbacks; ++k) {
    const auto claimed = store_->claim("test", lease_time).value();
    ASSERT_TRUE(store_->release(id_, claimed.job.attempt, 0));
  }
  begin().run();
  EXPECT_EQ(job().state, JobState::failed);
  EXPECT_EQ(nlohmann::json::parse(*job().error)["kind"], "infrastructure");
}

TEST_F(AttemptAtAJob, ThatLeftACheckpointWasNotInVain) {
  const auto claimed = store_->claim("test", lease_time).value();
  ASSERT_TRUE(store_->release(id_, claimed.job.attempt, 0));
  EXPECT_EQ(job().setbacks, 1);
  stop_at_once(StopReason::draining);
  EXPECT_EQ(job().setbacks, 0);
}

TEST_F(AttemptAtAJob, IsRepeatedLaterIfTheMachineFailed) {
  std::filesystem::remove(archives_);
  begin().run();
  EXPECT_EQ(job().state, JobState::queued);
  ASSERT_TRUE(job().not_before);
  EXPECT_GT(*job().not_before, storage::system_clock_ms());
}

TEST_F(AttemptAtAJob, FailsForGoodIfTheCaseCannotBePlanned) {
  store_->request_cancel(id_);
  id_ = submit(R"({"version": 1, "vessel": {"length": 20e-6, "diameter": 10e-6}, "duration": 1e-5,
                   "effects": {"bending": "on"}})");
  begin().run();
  EXPECT_EQ(job().state, JobState::failed);
  EXPECT_EQ(nlohmann::json::parse(*job().error)["kind"], "case");
  EXPECT_FALSE(has_files());
}

TEST_F(AttemptAtAJob, ThatGoesUnstableKeepsWhatItComputed) {
  store_->request_cancel(id_);
  id_ = submit(unstable_case);
  begin().run();
  const auto ended = job();
  EXPECT_EQ(ended.state, JobState::failed);
  const auto error = nlohmann::json::parse(*ended.error);
  EXPECT_EQ(error["kind"], "engine");
  EXPECT_EQ(error["cell"], 0);
  ASSERT_TRUE(ended.summary);
  EXPECT_EQ(nlohmann::json::parse(*ended.summary)["ending"], "failed");
  const storage::ArchiveReader archive(archive_path(archives_, id_));
  EXPECT_EQ(storage::sha256_hex_of_file(archive_path(archives_, id_)), ended.archive_sha256);
  EXPECT_EQ(archive.summary()["ending"], "failed");
  EXPECT_LT(archive.series({"time"}).values.at(0).back(), error["simulated_time"].get<double>());
  EXPECT_GT(archive.frame_count(), 1);
  EXPECT_EQ(live_.find(id_), nullptr) << "it is read from its archive";
}

TEST_F(AttemptAtAJob, ThatGoesUnstableWithoutItsLeasePublishesNothing) {
  store_->request_cancel(id_);
  id_ = submit(unstable_case);
  Attempt attempt = begin();
  ASSERT_TRUE(store_->release(id_, 1));
  attempt.run();
  EXPECT_EQ(job().state, JobState::queued);
  EXPECT_FALSE(has_files());
}

}  // namespace
}  // namespace rouleau::service
