#pragma once

#include <optional>
#include <string>

#include "storage/job.h"
#include "storage/sqlite/connection.h"
#include "storage/uuid.h"

namespace rouleau::storage {

/// What handing in a job and handing in a sweep of them have in common. These run within a transaction of the
/// writer.

/// @return the new job's id
std::string insert_job(Connection& database, const NewJob& submitted, UuidSource& ids, TimeMs now);

/// What a key was used for before, if it was.
/// @param column "job" or "sweep"
/// @throws IdempotencyMismatch
std::optional<std::string> find_keyed(Connection& database, const IdempotencyKey& key, const char* column);

void keep_key(Connection& database, const IdempotencyKey& key, const char* column, const std::string& id,
              TimeMs now);

}  // namespace rouleau::storage
