#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "service/client/api_client.h"
#include "service/client/server_error.h"

namespace rouleau::service {

/// Downloads the archive of a job and its .xdmf, unless they are there.
/// @return their names, size and sha256, and whether the archive `was_there`
nlohmann::json fetch_archive(ApiClient& client, const std::string& id, const std::filesystem::path& file);

/// Whether this is said of a job without one: it was deleted, or failed otherwise than by going unstable.
bool has_no_archive(const ServerError& error);

}  // namespace rouleau::service
