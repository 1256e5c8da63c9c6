#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/case/case_keys.h"

namespace rouleau::testing {

using KeyVisit = std::function<void(const Key& key, const std::string& place, const nlohmann::json& value)>;

/// Calls `visit` with every key of `object` that `document` says, its JSON Pointer and its value; of a list
/// with its first entry alone.
inline void for_each_said(const Key& object, const nlohmann::json& document, const std::string& pointer,
                          const KeyVisit& visit) {
  std::vector<Key> members = object.members;
  for (const Variant& variant : object.variants) {
    if (document.at(members.front().name) == variant.choice) members = members_of(object, variant);
  }
  for (const Key& member : members) {
    if (!document.contains(member.name)) continue;
    const nlohmann::json* value = &document.at(member.name);
    std::string place = pointer + '/' + member.name;
    visit(member, place, *value);
    const bool many = member.kind == Kind::list || (member.or_pair && value->is_array());
    if (many && value->empty()) continue;
    if (many) {
      place += "/0";
      value = &value->front();
    }
    const Key entry = member.kind == Kind::list ? entry_of(member) : member;
    if (entry.kind == Kind::tuple) {
      for (std::size_t k = 0; k < entry.members.size(); ++k) {
        visit(entry.members[k], place + '/' + std::to_string(k), value->at(k));
      }
    } else if (value->is_object()) {
      for_each_said(entry, *value, place, visit);
    }
  }
}

/// The same of a whole resolved case.
inline void for_each_said(const nlohmann::json& document, const KeyVisit& visit) {
  for_each_said(case_key(), document, "", visit);
}

}  // namespace rouleau::testing
