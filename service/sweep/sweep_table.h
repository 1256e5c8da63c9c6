#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/observe/record.h"

namespace rouleau::service {

/// What a sweep knows of one of its points.
struct SweepRow {
  std::size_t index = 0;
  std::string job;  ///< its id; "" where no service runs it
  std::string case_hash;
  std::vector<nlohmann::json> values;  ///< one an axis
  std::string state;
  nlohmann::json summary;  ///< of its run, null while there is none
};

/// A row a point: its axis values, its state, and what its run came to.
struct SweepTable {
  std::vector<Column> columns;  ///< those of the axes are named by their pointers, without a unit
  std::vector<std::vector<nlohmann::json>> rows;
};

/// @param pointers  of the axes
SweepTable make_table(const std::vector<std::string>& pointers, const std::vector<SweepRow>& rows);

/// `{ "columns": [...], "units": {...}, "rows": [[...], ...] }`
nlohmann::json to_json(const SweepTable& table);

/// What `to_json` told.
SweepTable read_table(const nlohmann::json& told);

/// One header line, then a line a row (RFC 4180); what is not known is empty.
std::string to_csv(const SweepTable& table);

}  // namespace rouleau::service
