#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "service/commands/client_options.h"

namespace rouleau::service {

/// Hands a sweep to a service.
/// @param folder  for the table and the archives once all points have ended; empty: none are fetched
/// @param wait    until then, also without a folder
/// @return the exit code
int sweep_there(ApiClient& client, const nlohmann::json& given, const std::filesystem::path& folder,
                bool wait, bool json);

}  // namespace rouleau::service
