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

json bare_schema(const Key& key);
json schema_of(const Key& key);

json object_schema(const std::vector<Key>& members) {
  json properties = json::object();
  json required = json::array();
  for (const Key& member : members) {
    properties[member.name] = schema_of(member);
    if (member.required) required.push_back(member.name);
  }
  json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

/// One branch for each variant, taken where the first member names it, or is left out and means it.
json variant_schema(const Key& key) {
  const Key& selector = key.members.front();
  json branches = json::array();
  for (const Variant& variant : key.variants) {
    json condition = {{"properties", {{selector.name, {{"const", variant.choice}}}}}};
    if (selector.fallback != variant.choice) condition["required"] = {selector.name};
    branches.push_back({{"if", condition}, {"then", object_schema(members_of(key, variant))}});
  }
  return {{"type", "object"}, {"properties", {{selector.name, schema_of(selector)}}}, {"allOf", branches}};
}

json tuple_schema(const Key& key) {
  json items = json::array();
  for (const Key& member : key.members) {
    json item = bare_schema(member);
    item["title"] = member.name;
    if (!member.unit.empty()) item["unit"] = member.unit;
    items.push_back(item);
  }
  return {{"type", "array"},
          {"items", items},
          {"minItems", items.size()},
          {"maxItems", items.size()},
          {"additionalItems", false}};
}

json list_schema(const Key& key) {
  json schema = {{"type", "array"}, {"maxItems", key.most_entries}, {"items", bare_schema(entry_of(key))}};
  if (key.distinct) schema["uniqueItems"] = true;
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
    case Kind::identifier:
      return {{"type", "string"}, {"maxLength", key.most_entries}, {"pattern", identifier_pattern}};
    case Kind::choice:
      return {{"type", "string"}, {"enum", key.choices}};
    case Kind::object:
      return object_schema(key.members);
    case Kind::variant:
      return variant_schema(key);
    case Kind::tuple:
      return tuple_schema(key);
    case Kind::list:
      return list_schema(key);
    case Kind::switch_map:
      return {{"type", "object"},
              {"maxProperties", key.most_entries},
              {"propertyNames", {{"pattern", lower_snake_case_pattern}}},
              {"additionalProperties",
               {{"anyOf",
                 {{{"type", "string"}, {"enum", key.choices}},
                  {{"type", "object"},
                   {"propertyNames", {{"pattern", lower_snake_case_pattern}}},
                   {"additionalProperties", {{"type", "number"}}}}}}}}};
  }
  return json::object();
}

json schema_of(const Key& key) {
  json schema = bare_schema(key);
  if (key.or_pair) {
    const json pair = {{"type", "array"}, {"items", schema}, {"minItems", 2}, {"maxItems", 2}};
    schema = {{"anyOf", {schema, pair}}};
  }
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
