#include <string>
#include <vector>

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/migrations.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

using Rows = std::vector<std::string>;

/// As a program that knew nothing but the first schema left it: a job in each state.
constexpr const char* jobs_of_the_first_schema = R"(
  WITH ended (state, rank) AS (VALUES ('queued', 1), ('running', 2), ('cancelling', 3), ('succeeded', 4),
                                      ('failed', 5), ('cancelled', 6))
  INSERT INTO jobs
    (id, state, name, case_hash, labels, priority, attempt, created_at, started_at, ended_at, not_before,
     lease_owner, lease_until, progress, summary, error, archive_size, archive_sha256)
  SELECT '01900000-0000-7000-8000-00000000000' || rank, state, 'job ' || rank, printf('%064d', rank),
         '{"lab":"A"}', rank, rank - 1, 1000 + rank, iif(rank > 1, 2000, NULL), iif(rank > 3, 3000, NULL),
         iif(rank = 1, 4000, NULL), iif(rank IN (2, 3), 'me', NULL), iif(rank IN (2, 3), 5000, NULL),
         iif(rank > 1, '{"fraction":0.5}', NULL), iif(rank = 4, '{"ending":"completed"}', NULL),
         iif(rank = 5, '{"kind":"engine"}', NULL), iif(rank = 4, 77, NULL),
         iif(rank = 4, printf('%064d', 7), NULL)
  FROM ended;
  INSERT INTO job_inputs SELECT id, '{"given":1}', '{"resolved":1}', '{"particles":10}' FROM jobs;
)";

Rows rows(SQLite::Database& database, const std::string& select) {
  Rows found;
  SQLite::Statement statement(database, select);
  while (statement.executeStep()) {
    std::string row;
    for (int k = 0; k < statement.getColumnCount(); ++k) {
      const auto column = statement.getColumn(k);
      row += std::string(statement.getColumnName(k)) + '=' + (column.isNull() ? "NULL" : column.getString()) +
             ' ';
    }
    found.push_back(row);
  }
  return found;
}

/// A data folder of the first schema.
class ReleasedSchema : public testing::Test {
 protected:
  ReleasedSchema() {
    SQLite::Database database = opened();
    migrate(database, {migrations().front()});
    database.exec(jobs_of_the_first_schema);
  }

  SQLite::Database opened() { return open_for_writing(folder.path() / "jobs.sqlite"); }

  ScratchFolder folder;
};

TEST_F(ReleasedSchema, KeepsEveryRowOnTheWayToTheNewest) {
  const auto all = [&] {
    SQLite::Database database = opened();
    Rows found =
        rows(database,
             "SELECT id, state, name, case_hash, labels, priority, attempt, created_at, started_at, "
             "ended_at, not_before, lease_owner, lease_until, progress, summary, error, archive_size, "
             "archive_sha256 FROM jobs ORDER BY id");
    for (const std::string& row : rows(database, "SELECT * FROM job_inputs ORDER BY job_id"))
      found.push_back(row);
    return found;
  };
  const Rows before = all();
  ASSERT_EQ(before.size(), 12u);
  { const JobStore store(folder.path()); }
  EXPECT_EQ(all(), before);
}

TEST_F(ReleasedSchema, EndsLikeADatabaseThatWasMadeAnew) {
  const ScratchFolder fresh;
  { const JobStore stores[] = {JobStore(folder.path()), JobStore(fresh.path())}; }
  SQLite::Database old = opened();
  SQLite::Database made = open_for_writing(fresh.path() / "jobs.sqlite");
  const std::string select = "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY type, name";
  EXPECT_EQ(rows(old, select), rows(made, select));
  EXPECT_TRUE(rows(old, "PRAGMA foreign_key_check").empty());
  EXPECT_EQ(rows(old, "PRAGMA integrity_check"), Rows{"integrity_check=ok "});
}

TEST_F(ReleasedSchema, ItsJobsGoOn) {
  JobStore store(folder.path());
  EXPECT_EQ(store.recover("next"), 2);
  const Job running = store.find("01900000-0000-7000-8000-000000000002").value();
  EXPECT_EQ(running.state, JobState::queued);
  const auto claim = store.claim("next", std::chrono::seconds(10));
  ASSERT_TRUE(claim);
  EXPECT_EQ(claim->text.given, R"({"given":1})");
  EXPECT_TRUE(store.fail(claim->job.id, claim->job.attempt, R"({"kind":"engine"})", some_result));
  EXPECT_EQ(store.find(claim->job.id)->summary, some_result.summary);
}

}  // namespace
}  // namespace rouleau::storage
