#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "storage/job.h"
#include "storage/sqlite/connection.h"

namespace rouleau::storage {

/// The reads that readers and the writer share; each is one statement.
std::optional<Job> select_job(Connection& database, std::string_view id);
std::optional<CaseText> select_case_text(Connection& database, std::string_view id);
/// @throws StoreError on a page token that no page gave
JobPage select_page(Connection& database, const JobQuery& query);

}  // namespace rouleau::storage
