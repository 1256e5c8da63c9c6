#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "service/sweep/sweep_table.h"

namespace rouleau::service {

/// Writes `table.csv`, and `sweep.json` with what `about` says of the sweep and the table, each aside and
/// renamed once it is whole.
/// @throws std::runtime_error
void write_sweep_files(const std::filesystem::path& folder, nlohmann::json about, const nlohmann::json& table,
                       const std::string& csv);

}  // namespace rouleau::service
