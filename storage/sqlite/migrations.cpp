#include "storage/sqlite/migrations.h"

#include <SQLiteCpp/Statement.h>

#include "storage/sqlite/database.h"
#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

int schema_version(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

/// Foreign keys are neither checked nor followed while this lives. SQLite takes it outside transactions only.
class ForeignKeysOff {
 public:
  explicit ForeignKeysOff(SQLite::Database& database) : database_(database) {
    database_.exec("PRAGMA foreign_keys = OFF");
  }
  ~ForeignKeysOff() { database_.tryExec("PRAGMA foreign_keys = ON"); }
  ForeignKeysOff(const ForeignKeysOff&) = delete;
  ForeignKeysOff& operator=(const ForeignKeysOff&) = delete;

 private:
  SQLite::Database& database_;
};

void apply(SQLite::Database& database, const Migration& migration) {
  database.exec("BEGIN EXCLUSIVE");
  try {
    database.exec(migration.sql);
    if (SQLite::Statement(database, "PRAGMA foreign_key_check").executeStep()) {
      throw StoreError(StoreError::Kind::corrupt,
                       database.getFilename() + ": " + migration.name + " would leave rows without theirs");
    }
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
  if (found == newest) return;
  // A table that is made anew is dropped first, which with them on would delete the rows that refer to it.
  const ForeignKeysOff off(database);
  for (const Migration& migration : known) {
    if (migration.number > found) apply(database, migration);
  }
}

}  // namespace rouleau::storage
