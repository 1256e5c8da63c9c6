#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/simulation/output.h"

namespace rouleau::service {

/// As the API's `progress` has it.
nlohmann::json to_json(const Progress& progress);

}  // namespace rouleau::service
