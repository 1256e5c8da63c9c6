#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "storage/archive_reader.h"

namespace rouleau::service {

/// `{ "columns": [...], "units": {...}, "rows": [[...], ...] }`; what is not finite is null.
nlohmann::json series_json(const storage::SeriesTable& table);

/// One header line, then a line a row; numbers with as many digits as tell them apart, nothing where a value
/// is not finite.
std::string series_csv(const storage::SeriesTable& table);

/// The rows of `table` after `time` (s), none of them if there is no column "time".
storage::SeriesTable rows_after(const storage::SeriesTable& table, double time);

/// Columns in the order named; empty names: all.
/// @throws Problem 400 unknown-column naming every column that there is not
storage::SeriesTable select_columns(const storage::SeriesTable& table, const std::vector<std::string>& names);

storage::SeriesTable select_rows(const storage::SeriesTable& table, const std::vector<std::size_t>& rows);

}  // namespace rouleau::service
