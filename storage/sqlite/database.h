#pragma once

#include <filesystem>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include "storage/store_error.h"

namespace rouleau::storage {

/// The one connection that writes, checkpoints and migrates.
SQLite::Database open_for_writing(const std::filesystem::path& file);

/// A connection that cannot change anything.
SQLite::Database open_for_reading(const std::filesystem::path& file);

/// Ends the open transaction, if SQLite has not already done so itself after a failure.
void roll_back(SQLite::Database& database) noexcept;

bool in_transaction(SQLite::Database& database);

/// What SQLite reports as the error that callers of the store tell apart.
StoreError to_store_error(const SQLite::Exception& error);

}  // namespace rouleau::storage
