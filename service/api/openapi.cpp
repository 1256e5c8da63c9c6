#include "service/api/openapi.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "service/api/service.h"

namespace rouleau::service {

void merge_description(nlohmann::ordered_json& whole, const nlohmann::ordered_json& part,
                       const std::string& at) {
  for (const auto& [key, value] : part.items()) {
    const auto found = whole.find(key);
    if (found == whole.end()) {
      whole[key] = value;
    } else if (found->is_object() && value.is_object()) {
      merge_description(*found, value, at + '/' + key);
    } else {
      throw std::logic_error("service/openapi says " + at + '/' + key + " twice");
    }
  }
}

nlohmann::ordered_json openapi_description() {
  nlohmann::ordered_json whole = nlohmann::ordered_json::object();
  for (const OpenapiPart& part : openapi_parts()) {
    merge_description(whole, nlohmann::ordered_json::parse(part.text));
  }
  return whole;
}

void add_openapi(Router& router) {
  router.add("GET", "/openapi.json",
             [text = openapi_description().dump()](const Call&, httplib::Response& response) {
               response.set_content(text, "application/json");
             });
}

}  // namespace rouleau::service
