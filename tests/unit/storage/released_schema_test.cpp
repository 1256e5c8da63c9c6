#include <fstream>
#include <iterator>
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

/// What selects every row with the columns that a table has now, whatever it may get later.
Rows selects_of_all(SQLite::Database& database) {
  Rows selects;
  SQLite::Statement tables(database, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn(0).getString();
    std::string columns;
    SQLite::Statement infos(database, "SELECT name FROM pragma_table_info('" + table + "')");
    while (infos.executeStep()) columns += (columns.empty() ? "" : ", ") + infos.getColumn(0).getString();
    selects.push_back("SELECT " + columns);
    selects.back() += " FROM " + table + " ORDER BY 1";
  }
  return selects;
}

/// The schema that a released program left, with jobs in every state that it knew.
struct Released {
  int number;
  int jobs;
};

void PrintTo(const Released& released, std::ostream* out) {
  *out << "schema " << released.number;
}

class ReleasedSchema : public testing::TestWithParam<Released> {
 protected:
  ReleasedSchema() {
    char name[16];
    std::snprintf(name, sizeof name, "/%04d.sql", GetParam().number);
    std::ifstream dump(ROULEAU_SCHEMAS + std::string(name));
    opened().exec(std::string(std::istreambuf_iterator<char>(dump), {}));
  }

  SQLite::Database opened() { return open_for_writing(folder.path() / "jobs.sqlite"); }

  std::string id(int k) const {
    char text[40];
    std::snprintf(text, sizeof text, "01900000-%04d-7000-8000-%012d", GetParam().number, k);
    return text;
  }

  ScratchFolder folder;
};

TEST_P(ReleasedSchema, KeepsEveryRowOnTheWayToTheNewest) {
  Rows selects;
  const auto all = [&] {
    SQLite::Database database = opened();
    if (selects.empty()) selects = selects_of_all(database);
    Rows found;
    for (const std::string& select : selects) {
      for (std::string& row : rows(database, select)) found.push_back(std::move(row));
    }
    return found;
  };
  const Rows before = all();
  ASSERT_GE(before.size(), 2u * static_cast<unsigned>(GetParam().jobs));
  { const JobStore store(folder.path()); }
  EXPECT_EQ(all(), before);
}

TEST_P(ReleasedSchema, EndsLikeADatabaseThatWasMadeAnew) {
  const ScratchFolder fresh;
  { const JobStore stores[] = {JobStore(folder.path()), JobStore(fresh.path())}; }
  SQLite::Database old = opened();
  SQLite::Database made = open_for_writing(fresh.path() / "jobs.sqlite");
  const std::string select = "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY type, name";
  EXPECT_EQ(rows(old, select), rows(made, select));
  EXPECT_TRUE(rows(old, "PRAGMA foreign_key_check").empty());
  EXPECT_EQ(rows(old, "PRAGMA integrity_check"), Rows{"integrity_check=ok "});
}

TEST_P(ReleasedSchema, ItsJobsAreReadAndGoOn) {
  JobStore store(folder.path());
  EXPECT_EQ(store.list({.page_size = 1000}).jobs.size(), static_cast<std::size_t>(GetParam().jobs));
  EXPECT_EQ(store.recover("next"), 2);
  EXPECT_EQ(store.find(id(2))->state, JobState::queued) << "ran when its program ended";
  EXPECT_EQ(store.find(id(3))->state, JobState::cancelled);
  const Job succeeded = store.find(id(4)).value();
  EXPECT_EQ(succeeded.state, JobState::succeeded);
  EXPECT_EQ(succeeded.archive_size, 1238);
  ASSERT_TRUE(store.find(id(5))->error);
  for (int waiting = 0; waiting < 3; ++waiting) {
    const auto claim = store.claim("next", std::chrono::seconds(10));
    ASSERT_TRUE(claim) << waiting;
    EXPECT_NE(claim->text.resolved.find("\"duration\":2e-05"), std::string::npos);
    EXPECT_TRUE(store.fail(claim->job.id, claim->job.attempt, R"({"kind":"engine"})", some_result));
    EXPECT_EQ(store.find(claim->job.id)->summary, some_result.summary);
  }
  EXPECT_FALSE(store.claim("next", std::chrono::seconds(10)));
}

INSTANTIATE_TEST_SUITE_P(Every, ReleasedSchema, testing::Values(Released{1, 8}, Released{2, 9}),
                         [](const auto& instance) { return std::to_string(instance.param.number); });

TEST(ReleasedSchemas, AreAllButTheOneInTheMaking) {
  // Whoever adds a migration puts the schema before it among those that are tried.
  EXPECT_LE(migrations().size(), 3u);
}

}  // namespace
}  // namespace rouleau::storage
