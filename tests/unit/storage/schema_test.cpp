#include <string>
#include <vector>

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "storage/job_statements.h"
#include "storage/job_store.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/migrations.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

/// A database that holds one job in each state, made by the store itself.
class Schema : public testing::Test {
 protected:
  Schema() : database(prepared()) {}

  SQLite::Database prepared() {
    {
      JobStore store(folder.path());
      const auto lease = std::chrono::seconds(100);
      for (int i = 0; i < 6; ++i) store.submit(plain_job());
      store.request_pause(store.submit(plain_job()).job.id);
      store.succeed(store.claim("me", lease)->job.id, 1, some_result);
      store.fail(store.claim("me", lease)->job.id, 1, "{}");
      store.fail(store.claim("me", lease)->job.id, 1, "{}", some_result);
      store.request_cancel(store.claim("me", lease)->job.id);
      store.claim("me", lease);
      store.request_cancel(store.submit(plain_job()).job.id);
    }
    return open_for_writing(folder.path() / "jobs.sqlite");
  }

  ScratchFolder folder;
  SQLite::Database database;
};

TEST_F(Schema, HoldsAJobInEachState) {
  EXPECT_EQ(database.execAndGet("SELECT count(DISTINCT state) FROM jobs").getInt(), 7);
}

TEST_F(Schema, RefusesWhatBreaksAnInvariant) {
  const std::vector<std::string> broken{
      "SET state = 'asleep' WHERE state = 'queued'",
      "SET state = 'paused' WHERE state = 'running'",
      "SET pause_requested = 1 WHERE state = 'queued'",
      "SET follows = id WHERE state = 'running'",
      "SET setbacks = -1",
      "SET fresh = 2",
      "SET sweep_index = 1",
      "SET archive_id = NULL WHERE state = 'succeeded'",
      "SET archive_id = 'short' WHERE state = 'succeeded'",
      "SET attempt = -1",
      "SET attempt = 'one'",
      "SET ended_at = NULL WHERE state = 'failed'",
      "SET ended_at = 5 WHERE state = 'running'",
      "SET ended_at = 5 WHERE state = 'queued'",
      "SET state = 'running' WHERE state = 'queued'",
      "SET state = 'queued' WHERE state = 'running'",
      "SET lease_owner = NULL WHERE state = 'running'",
      "SET lease_owner = NULL, lease_until = NULL WHERE state = 'cancelling'",
      "SET lease_until = NULL WHERE state = 'running'",
      "SET lease_owner = 'me', lease_until = 5 WHERE state = 'succeeded'",
      "SET started_at = NULL WHERE state = 'succeeded'",
      "SET attempt = 0 WHERE state = 'running'",
      "SET started_at = 5 WHERE state = 'queued'",
      "SET progress = '{' WHERE state = 'running'",
      "SET not_before = 5 WHERE state = 'running'",
      "SET summary = NULL WHERE state = 'succeeded'",
      "SET archive_sha256 = NULL WHERE state = 'succeeded'",
      "SET archive_sha256 = 'short' WHERE state = 'succeeded'",
      "SET archive_size = NULL WHERE state = 'succeeded'",
      "SET archive_size = 7 WHERE state = 'failed' AND summary IS NULL",
      "SET archive_sha256 = NULL WHERE state = 'failed' AND summary IS NOT NULL",
      "SET summary = NULL WHERE state = 'failed' AND summary IS NOT NULL",
      "SET summary = '{}' WHERE state = 'cancelled'",
      "SET error = NULL WHERE state = 'failed'",
      "SET error = '{}' WHERE state = 'succeeded'",
      "SET labels = '[]'",
      "SET case_hash = 'short'",
      "SET id = 'short'",
      "SET name = NULL",
  };
  for (const std::string& change : broken) {
    EXPECT_THROW(database.exec("UPDATE jobs " + change), SQLite::Exception) << change;
  }
}

TEST_F(Schema, KeepsInputsAndJobsTogether) {
  EXPECT_THROW(database.exec("INSERT INTO job_inputs VALUES ('nobody', '{}', '{}', '{}')"),
               SQLite::Exception);
  database.exec("DELETE FROM jobs");
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM job_inputs").getInt(), 0);
}

TEST_F(Schema, ClaimsWalkTheIndexOfWhatWaits) {
  for (const std::string& select : {first_lane, next_lane, oldest_of_lane}) {
    SQLite::Statement plan(database, "EXPLAIN QUERY PLAN " + select);
    std::string steps;
    while (plan.executeStep()) steps += plan.getColumn(3).getString() + "\n";
    EXPECT_NE(steps.find("INDEX jobs_waiting"), std::string::npos) << steps;
    EXPECT_EQ(steps.find("TEMP B-TREE"), std::string::npos) << steps;
  }
}

TEST_F(Schema, RunsWithTheDurabilityThatWasPromised) {
  EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "wal");
  EXPECT_EQ(database.execAndGet("PRAGMA synchronous").getInt(), 2) << "FULL";
  EXPECT_EQ(database.execAndGet("PRAGMA foreign_keys").getInt(), 1);
  EXPECT_EQ(database.execAndGet("PRAGMA journal_size_limit").getInt(), 4 << 20);
}

}  // namespace
}  // namespace rouleau::storage
