#include "storage/sqlite/migrations.h"

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "storage/sqlite/database.h"
#include "storage/store_error.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

int version(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

const Migration first{1, "0001_a", "CREATE TABLE a (x INTEGER) STRICT; INSERT INTO a VALUES (7);"};
const Migration second{2, "0002_b", "ALTER TABLE a ADD COLUMN y INTEGER; UPDATE a SET y = 2 * x;"};

TEST(Migrations, AreNumberedFromOneWithoutGaps) {
  ASSERT_FALSE(migrations().empty());
  int expected = 1;
  for (const Migration& migration : migrations()) {
    EXPECT_EQ(migration.number, expected++);
    EXPECT_FALSE(migration.sql.empty());
  }
}

TEST(Migrations, ApplyWhatIsMissingAndKeepTheData) {
  const ScratchFolder folder;
  SQLite::Database database = open_for_writing(folder.path() / "x.sqlite");
  migrate(database, {first});
  EXPECT_EQ(version(database), 1);
  migrate(database, {first, second});
  EXPECT_EQ(version(database), 2);
  EXPECT_EQ(database.execAndGet("SELECT y FROM a").getInt(), 14);
  migrate(database, {first, second});
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM a").getInt(), 1);
}

TEST(Migrations, AStepThatFailsLeavesNothingBehind) {
  const ScratchFolder folder;
  SQLite::Database database = open_for_writing(folder.path() / "x.sqlite");
  const Migration broken{2, "0002_broken", "CREATE TABLE b (x INTEGER) STRICT; CREATE TABLE a (x INTEGER);"};
  EXPECT_THROW(migrate(database, {first, broken}), SQLite::Exception);
  EXPECT_EQ(version(database), 1);
  EXPECT_FALSE(database.tableExists("b"));
  migrate(database, {first, second});
  EXPECT_EQ(version(database), 2);
}

TEST(Migrations, AStepMayMakeATableAnewThatOthersReferTo) {
  const Migration tables{1, "0001_tables",
                         "CREATE TABLE a (x INTEGER PRIMARY KEY) STRICT; INSERT INTO a VALUES (7);"
                         "CREATE TABLE b (x INTEGER REFERENCES a (x) ON DELETE CASCADE) STRICT;"
                         "INSERT INTO b VALUES (7);"};
  const std::string anew = "CREATE TABLE c (x INTEGER PRIMARY KEY, y INTEGER) STRICT;";
  const std::string over = "DROP TABLE a; ALTER TABLE c RENAME TO a;";
  const ScratchFolder folder;
  SQLite::Database database = open_for_writing(folder.path() / "x.sqlite");
  EXPECT_THROW(migrate(database, {tables, {2, "0002_forgets_the_rows", anew + over}}), StoreError);
  EXPECT_EQ(version(database), 1);
  migrate(database, {tables, {2, "0002_a", anew + "INSERT INTO c SELECT x, 1 FROM a;" + over}});
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM b").getInt(), 1);
  EXPECT_EQ(database.execAndGet("PRAGMA foreign_keys").getInt(), 1);
}

TEST(Migrations, RefuseADatabaseOfANewerProgram) {
  const ScratchFolder folder;
  { const JobStore store(folder.path()); }
  open_for_writing(folder.path() / "jobs.sqlite").exec("PRAGMA user_version = 999");
  try {
    const JobStore store(folder.path());
    FAIL() << "opened";
  } catch (const StoreError& error) {
    EXPECT_EQ(error.kind(), StoreError::Kind::schema_too_new);
    EXPECT_NE(std::string(error.what()).find("999"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rouleau::storage
