#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace rouleau::service {

/// @throws CommandError (bad input) if the file cannot be read or is larger than a case may be
std::string read_case_file(const std::filesystem::path& file);

/// Sets values in a case. Each is `/json/pointer=value`, the value being JSON or else a text.
/// @throws CommandError (bad input)
void apply_settings(nlohmann::json& document, const std::vector<std::string>& settings);

}  // namespace rouleau::service
