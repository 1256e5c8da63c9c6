#include "service/queue/failure.h"

#include <new>
#include <system_error>

#include <gtest/gtest.h>

#include "engine/case/case_error.h"
#include "engine/error/simulation_error.h"
#include "storage/archive_error.h"
#include "storage/store_error.h"

namespace rouleau::service {
namespace {

using Kind = Failure::Kind;
using storage::ArchiveError;
using storage::StoreError;

TEST(Failure, OfARunThatWentUnstableSaysWhatWhenAndWhere) {
  Breach breach;
  breach.quantity = "speed";
  breach.value = 3;
  breach.bound = 0.5;
  breach.unit = "m/s";
  breach.time = 1e-3;
  breach.step = 70;
  breach.x = 2e-6;
  breach.y = 1e-6;
  breach.particle = 17;
  const Failure failure = failure_of(SimulationError(breach));
  EXPECT_EQ(failure.kind, Kind::engine);
  EXPECT_EQ(failure.error["kind"], "engine");
  EXPECT_EQ(failure.error["quantity"], "speed");
  EXPECT_EQ(failure.error["bound"], 0.5);
  EXPECT_EQ(failure.error["simulated_time"], 1e-3);
  EXPECT_EQ(failure.error["step"], 70);
  EXPECT_EQ(failure.error["x"], 2e-6);
  EXPECT_EQ(failure.error["particle"], 17);
}

TEST(Failure, OfTheWholeRunHasNoPlace) {
  const Failure failure =
      failure_of(SimulationError(Breach{.quantity = "residual", .value = 2, .bound = 1, .unit = "1"}));
  EXPECT_FALSE(failure.error.contains("x") || failure.error.contains("y"));
  EXPECT_EQ(failure.error["particle"], -1);
}

TEST(Failure, OfACaseListsItsFaults) {
  const Failure failure = failure_of(CaseError(std::vector<Fault>{{"/effects/bending", "cannot be on"}}));
  EXPECT_EQ(failure.kind, Kind::case_);
  EXPECT_EQ(failure.error["errors"][0]["pointer"], "/effects/bending");
}

TEST(Failure, TellsTheMachineFromTheRun) {
  EXPECT_EQ(failure_of(ArchiveError(ArchiveError::Kind::disk_full, "full")).kind, Kind::infrastructure);
  EXPECT_EQ(failure_of(ArchiveError(ArchiveError::Kind::misuse, "order")).kind, Kind::engine);
  EXPECT_EQ(failure_of(StoreError(StoreError::Kind::io, "disk")).kind, Kind::infrastructure);
  EXPECT_EQ(failure_of(std::system_error(ENOSPC, std::generic_category())).kind, Kind::infrastructure);
  EXPECT_EQ(failure_of(std::bad_alloc()).kind, Kind::infrastructure);
  EXPECT_EQ(failure_of(std::logic_error("bug")).kind, Kind::engine);
}

TEST(Retry, WaitsLongerEachTimeAndGivesUpAfterFive) {
  auto before = std::chrono::seconds(0);
  for (int attempt = 1; attempt <= 4; ++attempt) {
    const auto gap = retry_after(attempt);
    ASSERT_TRUE(gap) << attempt;
    EXPECT_GT(*gap, before);
    before = *gap;
  }
  EXPECT_FALSE(retry_after(5));
}

}  // namespace
}  // namespace rouleau::service
