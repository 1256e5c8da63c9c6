#include "engine/case/key_checks.h"

#include <algorithm>
#include <cmath>

#include "engine/case/wording.h"

namespace rouleau {
namespace {

using nlohmann::json;

bool is_choice(const json& value, const Key& key) {
  return value.is_string() && std::find(key.choices.begin(), key.choices.end(),
                                        value.get_ref<const std::string&>()) != key.choices.end();
}

bool is_number(const json& value, const Key& key) {
  if (key.or_auto && value == "auto") return true;
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  // JSON Schema's integers: 1.0 is one, 3.9 is none.
  if (key.kind == Kind::integer && number != std::floor(number)) return false;
  return key.range.holds(number);
}

bool is_valid_utf8(const json& text) {
  try {
    (void)text.dump();
    return true;
  } catch (const json::type_error&) {
    return false;
  }
}

bool is_text(const json& value, const Key& key) {
  if (!value.is_string() || !is_valid_utf8(value)) return false;
  const std::string& text = value.get_ref<const std::string&>();
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto controls = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins)) <= key.most_entries &&
         std::none_of(text.begin(), text.end(), controls);
}

bool is_name(const json& value, const Key& key) {
  if (!value.is_string()) return false;
  const std::string& text = value.get_ref<const std::string&>();
  return text.size() <= key.most_entries && is_identifier(text);
}

std::vector<std::string> names_of(const std::vector<Key>& members) {
  std::vector<std::string> names;
  for (const Key& member : members) names.push_back(member.name);
  return names;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Where else an unknown key would be known, or what it may have been meant to be.
std::string hint_at(const std::string& name, const Key& object, const std::vector<std::string>& names) {
  std::string elsewhere;
  for (const Variant& variant : object.variants) {
    if (!holds(names_of(variant.members), name)) continue;
    elsewhere += (elsewhere.empty() ? "\"" : " or \"") + variant.choice + '"';
  }
  if (elsewhere.empty()) return did_you_mean(name, names);
  return "; it belongs to the " + object.members.front().name + ' ' + elsewhere + ';';
}

json sound_members(const json& value, const Key& object, const std::vector<Key>& members,
                   const std::string& pointer, Faults& faults) {
  json sound = json::object();
  const std::vector<std::string> names = names_of(members);
  for (const auto& [name, unused] : value.items()) {
    if (holds(names, name)) continue;
    const std::string hint = hint_at(name, object, names);
    faults.add(pointer_to(pointer, name),
               "unknown key" + (hint.empty() ? ";" : hint) + " allowed here: " + listed(names));
  }
  for (const Key& member : members) {
    const std::string place = pointer_to(pointer, member.name);
    const auto given = value.find(member.name);
    if (given != value.end()) {
      json part = sound_part(*given, member, place, faults);
      if (!part.is_null()) sound[member.name] = std::move(part);
    } else if (member.required) {
      faults.add(place, "missing; needed is " + allowed(member));
    }
  }
  return sound;
}

/// Without a sound choice of the variant nothing can be said of the other members.
json sound_variant(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  const Key& selector = key.members.front();
  json choice = selector.fallback;
  if (const auto given = value.find(selector.name); given != value.end()) {
    choice = sound_part(*given, selector, pointer_to(pointer, selector.name), faults);
  }
  for (const Variant& variant : key.variants) {
    if (choice == variant.choice) {
      return sound_members(value, key, members_of(key, variant), pointer, faults);
    }
  }
  return json::object();
}

/// A list of which every entry is sound, or null.
template <typename KeyAt>
json sound_entries(const json& value, const std::string& pointer, Faults& faults, const KeyAt& key_at) {
  json sound = json::array();
  for (std::size_t k = 0; k < value.size(); ++k) {
    json entry = sound_part(value[k], key_at(k), pointer_to(pointer, k), faults);
    if (!entry.is_null()) sound.push_back(std::move(entry));
  }
  return sound.size() == value.size() ? sound : json(nullptr);
}

void refuse_repetitions(const json& value, const std::string& pointer, Faults& faults) {
  for (auto entry = value.begin(); entry != value.end(); ++entry) {
    if (std::find(value.begin(), entry, *entry) == entry) continue;
    const auto index = static_cast<std::size_t>(std::distance(value.begin(), entry));
    faults.add(pointer_to(pointer, index), "found " + found(*entry) + " again; each is allowed once");
  }
}

json sound_list(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  const Key entry = entry_of(key);
  if (key.distinct) refuse_repetitions(value, pointer, faults);
  if (entry.kind != Kind::object) {
    return sound_entries(value, pointer, faults, [&](std::size_t) -> const Key& { return entry; });
  }
  json sound = json::array();
  for (std::size_t k = 0; k < value.size(); ++k) {
    json part = sound_part(value[k], entry, pointer_to(pointer, k), faults);
    sound.push_back(part.is_null() ? json::object() : std::move(part));
  }
  return sound;
}

json sound_pair(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  Key one = key;
  one.or_pair = false;
  return sound_entries(value, pointer, faults, [&](std::size_t) -> const Key& { return one; });
}

json sound_numbers(const json& value, const std::string& pointer, Faults& faults) {
  json sound = json::object();
  for (const auto& [name, number] : value.items()) {
    const std::string place = pointer_to(pointer, name);
    if (!is_lower_snake_case(name)) {
      faults.add(place, "found " + found(name) + " for a name; allowed are lower-case words joined by _");
    } else if (!number.is_number()) {
      faults.add(place, "found " + found(number) + "; allowed is a number");
    } else {
      sound[name] = number;
    }
  }
  return sound;
}

json sound_switches(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  json sound = json::object();
  for (const auto& [name, position] : value.items()) {
    const std::string place = pointer_to(pointer, name);
    if (!is_lower_snake_case(name)) {
      faults.add(place, "found " + found(name) + " for a name; allowed are lower-case words joined by _");
    } else if (position.is_object()) {
      sound[name] = sound_numbers(position, place, faults);
    } else if (!is_choice(position, key)) {
      faults.add(place, "found " + found(position) + "; allowed is one of " + listed(key.choices) +
                            ", or an object of numbers");
    } else {
      sound[name] = position;
    }
  }
  return sound;
}

bool fits(const json& value, const Key& key) {
  if (key.or_pair && value.is_array()) return value.size() == 2;
  switch (key.kind) {
    case Kind::number:
    case Kind::integer:
      return is_number(value, key);
    case Kind::text:
      return is_text(value, key);
    case Kind::identifier:
      return is_name(value, key);
    case Kind::choice:
      return is_choice(value, key);
    case Kind::object:
    case Kind::variant:
      return value.is_object();
    case Kind::tuple:
      return value.is_array() && value.size() == key.members.size();
    case Kind::list:
      return value.is_array() && value.size() <= key.most_entries;
    case Kind::switch_map:
      return value.is_object() && value.size() <= key.most_entries;
  }
  return false;
}

}  // namespace

json sound_part(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  if (!fits(value, key)) {
    faults.add(pointer, "found " + found(value) + "; allowed is " + allowed(key));
    return nullptr;
  }
  if (key.or_pair && value.is_array()) return sound_pair(value, key, pointer, faults);
  switch (key.kind) {
    case Kind::object:
      return sound_members(value, key, key.members, pointer, faults);
    case Kind::variant:
      return sound_variant(value, key, pointer, faults);
    case Kind::tuple:
      return sound_entries(value, pointer, faults,
                           [&](std::size_t k) -> const Key& { return key.members[k]; });
    case Kind::list:
      return sound_list(value, key, pointer, faults);
    case Kind::switch_map:
      return sound_switches(value, key, pointer, faults);
    default:
      return value;
  }
}

}  // namespace rouleau
