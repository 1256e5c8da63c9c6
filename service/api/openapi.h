#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace rouleau::service {

/// One file of service/openapi/, compiled in: the paths of a resource and the schemas that are its own.
struct OpenapiPart {
  std::string_view name;
  std::string_view text;
};

const std::vector<OpenapiPart>& openapi_parts();

/// Adds the members of `part` to `whole`, and those of objects that both have, on every level.
/// @throws std::logic_error for what both say
void merge_description(nlohmann::ordered_json& whole, const nlohmann::ordered_json& part,
                       const std::string& at = "");

/// All parts as one document.
nlohmann::ordered_json openapi_description();

}  // namespace rouleau::service
