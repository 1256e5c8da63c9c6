#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace rouleau::service {

/// How a run ended and what it came to, for a person.
/// @param summary as `to_json(RunSummary)` gives it, here or from a server
std::string describe_summary(const nlohmann::json& summary);

}  // namespace rouleau::service
