#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "service/client/api_client.h"

namespace rouleau::service {

/// Downloads the archive of a job and its .xdmf, unless they are there.
/// @return their names, size and sha256, and whether the archive `was_there`
nlohmann::json fetch_archive(ApiClient& client, const std::string& id, const std::filesystem::path& file);

}  // namespace rouleau::service
