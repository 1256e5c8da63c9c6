#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <SQLiteCpp/Database.h>

#include "storage/job.h"

namespace rouleau::storage {

/// The reads that readers and the writer share; each is one statement.
std::optional<Job> select_job(SQLite::Database& database, std::string_view id);
std::optional<CaseText> select_case_text(SQLite::Database& database, std::string_view id);
/// @throws StoreError on a page token that no page gave
JobPage select_page(SQLite::Database& database, const JobQuery& query);

}  // namespace rouleau::storage
