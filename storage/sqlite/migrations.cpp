#include "storage/sqlite/migrations.h"

#include "storage/sqlite/database.h"
#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

int schema_version(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

void apply(SQLite::Database& database, const Migration& migration) {
  database.exec("BEGIN EXCLUSIVE");
  try {
    database.exec(migration.sql);
    database.exec("PRAGMA user_version = " + std::to_string(migration.number));
    database.exec("COMMIT");
  } catch (...) {
    roll_back(database);
    throw;
  }
}

}  // namespace

void migrate(SQLite::Database& database, const std::vector<Migration>& known) {
  const int newest = known.empty() ? 0 : known.back().number;
  const int found = schema_version(database);
  if (found > newest) {
    throw StoreError(StoreError::Kind::schema_too_new,
                     database.getFilename() + " has schema version " + std::to_string(found) +
                         ", this program knows up to " + std::to_string(newest) +
                         "; start the newer program that wrote it");
  }
  for (const Migration& migration : known) {
    if (migration.number > found) apply(database, migration);
  }
}

}  // namespace rouleau::storage
