#include "service/api/openapi.h"

#include <functional>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rouleau::service {
namespace {

using nlohmann::ordered_json;

TEST(Openapi, MergesObjectsOnEveryLevel) {
  auto whole = ordered_json::parse(R"({"a": {"b": {"c": 1}}, "d": 2})");
  merge_description(whole, ordered_json::parse(R"({"a": {"b": {"e": 3}, "f": 4}})"));
  EXPECT_EQ(whole, ordered_json::parse(R"({"a": {"b": {"c": 1, "e": 3}, "f": 4}, "d": 2})"));
}

TEST(Openapi, RefusesWhatIsSaidTwice) {
  auto whole = ordered_json::parse(R"({"a": {"b": 1}})");
  EXPECT_THROW(merge_description(whole, ordered_json::parse(R"({"a": {"b": 1}})")), std::logic_error);
  EXPECT_THROW(merge_description(whole, ordered_json::parse(R"({"a": 1})")), std::logic_error);
}

TEST(Openapi, RefersToWhatItHasAndHasNothingThatNobodyRefersTo) {
  const ordered_json whole = openapi_description();
  std::set<std::string> referred;
  const std::function<void(const ordered_json&)> visit = [&](const ordered_json& value) {
    if (value.is_object() && value.contains("$ref")) {
      const std::string reference = value["$ref"];
      ASSERT_TRUE(reference.starts_with("#/")) << reference;
      EXPECT_TRUE(whole.contains(ordered_json::json_pointer(reference.substr(1)))) << reference;
      referred.insert(reference);
    }
    if (value.is_structured()) {
      for (const auto& member : value) visit(member);
    }
  };
  visit(whole);
  for (const auto& [name, schema] : whole["components"]["schemas"].items()) {
    EXPECT_TRUE(referred.contains("#/components/schemas/" + name)) << name;
  }
}

}  // namespace
}  // namespace rouleau::service
