#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/case/case_keys.h"

namespace rouleau {
namespace {

using nlohmann::json;

json number_schema(const Key& key) {
  const Range& range = key.range;
  json bounds = {{range.above_least ? "exclusiveMinimum" : "minimum", range.least},
                 {range.below_most ? "exclusiveMaximum" : "maximum", range.most}};
  json schema = {{"type", key.kind == Kind::integer ? "integer" : "number"}};
  if (range.or_zero) {
    schema["anyOf"] = {bounds, {{"minimum", 0}, {"maximum", 0}}};
  } else {
    schema.update(bounds);
  }
  if (key.or_auto) schema = {{"anyOf", {schema, {{"const", "auto"}}}}};
  return schema;
}

json schema_of(const Key& key);

json object_schema(const Key& key) {
  json properties = json::object();
  json required = json::array();
  for (const Key& member : key.members) {
    properties[member.name] = schema_of(member);
    if (member.required) required.push_back(member.name);
  }
  json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

json bare_schema(const Key& key) {
  switch (key.kind) {
    case Kind::number:
    case Kind::integer:
      return number_schema(key);
    case Kind::text:
      return {
          {"type", "string"}, {"maxLength", key.most_entries}, {"pattern", "^[^\\u0000-\\u001f\\u007f]*$"}};
    case Kind::choice:
      return {{"type", "string"}, {"enum", key.choices}};
    case Kind::object:
      return object_schema(key);
    case Kind::list:
      return {{"type", "array"}, {"maxItems", key.most_entries}, {"items", object_schema(key)}};
    case Kind::switch_map:
      return {{"type", "object"},
              {"maxProperties", key.most_entries},
              {"propertyNames", {{"pattern", lower_snake_case_pattern}}},
              {"additionalProperties", {{"type", "string"}, {"enum", key.choices}}}};
  }
  return json::object();
}

json schema_of(const Key& key) {
  json schema = bare_schema(key);
  schema["description"] = key.description;
  if (!key.unit.empty()) schema["unit"] = key.unit;
  if (!key.fallback.is_null()) schema["default"] = key.fallback;
  return schema;
}

json whole_schema() {
  json schema = schema_of(case_key());
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Rouleau case, version 1";
  return schema;
}

}  // namespace

const json& case_schema() {
  static const json schema = whole_schema();
  return schema;
}

}  // namespace rouleau
