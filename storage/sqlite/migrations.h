#pragma once

#include <string>
#include <vector>

#include <SQLiteCpp/Database.h>

namespace rouleau::storage {

/// One step of the schema: a file of storage/migrations, built into the program.
struct Migration {
  int number = 0;
  std::string name;
  std::string sql;
};

/// In order, numbered from 1 without gaps.
const std::vector<Migration>& migrations();

/// Applies what the database lacks, each step in an exclusive transaction that also records its number in
/// `user_version`. A step may make a table anew: no foreign key is followed while steps are applied, and none
/// may dangle after one.
/// @throws StoreError if the database has steps that `known` lacks
void migrate(SQLite::Database& database, const std::vector<Migration>& known = migrations());

}  // namespace rouleau::storage
