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

std::vector<std::string> names_of(const Key& object) {
  std::vector<std::string> names;
  for (const Key& member : object.members) names.push_back(member.name);
  return names;
}

void refuse_unknown_keys(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  const std::vector<std::string> names = names_of(key);
  for (const auto& [name, unused] : value.items()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string hint = did_you_mean(name, names);
    faults.add(pointer_to(pointer, name),
               "unknown key" + (hint.empty() ? ";" : hint) + " allowed here: " + listed(names));
  }
}

json sound_object(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  json sound = json::object();
  refuse_unknown_keys(value, key, pointer, faults);
  for (const Key& member : key.members) {
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

json sound_list(const json& value, const Key& key, const std::string& pointer, Faults& faults) {
  json sound = json::array();
  for (std::size_t k = 0; k < value.size(); ++k) {
    const std::string place = pointer_to(pointer, k);
    if (value[k].is_object()) {
      sound.push_back(sound_object(value[k], key, place, faults));
    } else {
      faults.add(place, "found " + found(value[k]) + "; allowed is an object");
      sound.push_back(json::object());
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
    } else if (!is_choice(position, key)) {
      faults.add(place, "found " + found(position) + "; allowed is one of " + listed(key.choices));
    } else {
      sound[name] = position;
    }
  }
  return sound;
}

bool fits(const json& value, const Key& key) {
  switch (key.kind) {
    case Kind::number:
    case Kind::integer:
      return is_number(value, key);
    case Kind::text:
      return is_text(value, key);
    case Kind::choice:
      return is_choice(value, key);
    case Kind::object:
      return value.is_object();
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
  switch (key.kind) {
    case Kind::object:
      return sound_object(value, key, pointer, faults);
    case Kind::list:
      return sound_list(value, key, pointer, faults);
    case Kind::switch_map:
      return sound_switches(value, key, pointer, faults);
    default:
      return value;
  }
}

}  // namespace rouleau
