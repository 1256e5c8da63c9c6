#include "storage/sqlite/database.h"

#include <cerrno>
#include <sqlite3.h>

namespace rouleau::storage {

namespace {

// Only another program that holds the file can make us wait (a backup, an sqlite3 shell), for our writes
// come from one connection.
constexpr int busy_timeout_ms = 5000;

StoreError::Kind kind_of(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return StoreError::Kind::disk_full;
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return StoreError::Kind::io;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return StoreError::Kind::busy;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return StoreError::Kind::corrupt;
    case SQLITE_CONSTRAINT:
    case SQLITE_TOOBIG:
      return StoreError::Kind::invalid_argument;
    default:
      return StoreError::Kind::internal;
  }
}

}  // namespace

SQLite::Database open_for_writing(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_timeout_ms);
  // Readers go on while the writer commits, and a commit is one append and one sync.
  database.exec("PRAGMA journal_mode = WAL");
  // A job that was accepted must outlive a power cut; NORMAL syncs the log at checkpoints only.
  database.exec("PRAGMA synchronous = FULL");
  // Off by default in SQLite, and per connection.
  database.exec("PRAGMA foreign_keys = ON");
  // Without it the log keeps the largest size that it ever had.
  database.exec("PRAGMA journal_size_limit = 4194304");
  // The journals of savepoints: beginning in a file of their own, each takes and returns 64 KiB.
  database.exec("PRAGMA temp_store = MEMORY");
  return database;
}

SQLite::Database open_for_reading(const std::filesystem::path& file) {
  return SQLite::Database(file.string(), SQLite::OPEN_READONLY, busy_timeout_ms);
}

bool in_transaction(SQLite::Database& database) {
  return sqlite3_get_autocommit(database.getHandle()) == 0;
}

void roll_back(SQLite::Database& database) noexcept {
  if (in_transaction(database)) database.tryExec("ROLLBACK");
}

StoreError to_store_error(const SQLite::Exception& error) {
  return StoreError(kind_of(error.getErrorCode()), std::string("database: ") + error.what());
}

}  // namespace rouleau::storage
