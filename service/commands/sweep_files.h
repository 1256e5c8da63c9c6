#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace rouleau::service {

/// What a sweep leaves beside its archives.
struct SweepFiles {
  nlohmann::json about;  ///< of the sweep; goes to `sweep.json` with the table
  nlohmann::json table;
  std::string csv;      ///< `table.csv`
  std::string picture;  ///< `sweep.svg`; empty: none
};

/// Writes them, each aside and renamed once it is whole.
/// @throws std::runtime_error
void write_sweep_files(const std::filesystem::path& folder, SweepFiles files);

}  // namespace rouleau::service
