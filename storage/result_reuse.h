#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <SQLiteCpp/Database.h>

#include "storage/job.h"

namespace rouleau::storage {

/// A result is computed once. These run within a transaction of the writer.

/// A job that has the result of this hash, if there is one.
std::optional<std::string> job_with_result(SQLite::Database& database, std::string_view case_hash);

/// The job of this hash that runs and will have the result, if there is one.
std::optional<std::string> job_on_the_way(SQLite::Database& database, std::string_view case_hash);

/// A job that waits gets the result of `source` and has succeeded.
void give_result(SQLite::Database& database, std::string_view id, std::string_view source, TimeMs now);

/// All that wait for the same result as `source`, which has just succeeded, get it.
void give_result_to_all(SQLite::Database& database, std::string_view source, TimeMs now);

/// A job that waits leaves the queue until `leader` has ended.
void follow(SQLite::Database& database, std::string_view id, std::string_view leader);

/// Whoever waited for a job's result waits for a worker of its own.
void release_followers(SQLite::Database& database, std::string_view leader);

}  // namespace rouleau::storage
