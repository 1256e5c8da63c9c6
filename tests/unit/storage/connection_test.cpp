#include "storage/sqlite/connection.h"

#include <gtest/gtest.h>

#include "storage/sqlite/database.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

class PreparedStatements : public testing::Test {
 protected:
  PreparedStatements() : database(open_for_writing(folder.path() / "x.sqlite")) {
    database.exec("CREATE TABLE numbers (n INTEGER) STRICT; INSERT INTO numbers VALUES (1), (2)");
  }

  ScratchFolder folder;
  Connection database;
  const std::string insert = "INSERT INTO numbers VALUES (?)";
  const std::string all = "SELECT n FROM numbers ORDER BY n";
};

TEST_F(PreparedStatements, AreLentAgainWithoutTheirValues) {
  SQLite::Statement* first = nullptr;
  {
    Prepared statement(database, insert);
    statement.bind(1, 3);
    statement.exec();
    first = &statement.statement();
  }
  Prepared again(database, insert);
  EXPECT_EQ(&again.statement(), first);
  again.exec();
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM numbers WHERE n IS NULL").getInt(), 1);
}

TEST_F(PreparedStatements, MayBeLentTwiceAtATime) {
  int pairs = 0;
  Prepared outer(database, all);
  while (outer.executeStep()) {
    Prepared inner(database, all);
    while (inner.executeStep()) ++pairs;
  }
  EXPECT_EQ(pairs, 4);
}

TEST_F(PreparedStatements, OnesThatFailedOrWereLeftHalfwayServeAgain) {
  database.exec("CREATE UNIQUE INDEX once ON numbers (n)");
  for (int k = 0; k < 2; ++k) {
    Prepared statement(database, insert);
    statement.bind(1, 1);
    EXPECT_THROW(statement.exec(), SQLite::Exception);
  }
  for (int k = 0; k < 2; ++k) {
    Prepared statement(database, all);
    ASSERT_TRUE(statement.executeStep());
    EXPECT_EQ(statement.getColumn(0).getInt(), 1);
  }
  database.exec("DROP TABLE numbers");  // which no open statement may hinder
}

}  // namespace
}  // namespace rouleau::storage
