#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "storage/job.h"
#include "storage/sqlite/connection.h"

namespace rouleau::storage {

/// A result is computed once. These run within a transaction of the writer.

/// A job that has the result of this hash, if there is one.
std::optional<std::string> job_with_result(Connection& database, std::string_view case_hash);

/// The job of this hash that runs and will have the result, if there is one.
std::optional<std::string> job_on_the_way(Connection& database, std::string_view case_hash);

/// A job that waits gets the result of `source` and has succeeded.
void give_result(Connection& database, std::string_view id, std::string_view source, TimeMs now);

/// All that wait for the same result as `source`, which has just succeeded, get it.
void give_result_to_all(Connection& database, std::string_view source, TimeMs now);

/// A job that waits leaves the queue until `leader` has ended.
void follow(Connection& database, std::string_view id, std::string_view leader);

/// Whoever waited for a job's result waits for a worker of its own.
void release_followers(Connection& database, std::string_view leader);

}  // namespace rouleau::storage
