#include "engine/case/wording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <numeric>

namespace rouleau {
namespace {

using nlohmann::json;

/// At most so many code points of what was written are repeated to its author.
constexpr std::size_t longest_quote = 60;

std::string quoted(const std::string& text) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    const bool begins = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (begins && count++ == longest_quote) break;
  }
  const json start = text.substr(0, end) + (end < text.size() ? "…" : "");
  return start.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string bounds(const Range& range) {
  if (range.least == range.most) return " equal to " + in_words(range.least);
  const std::string least = (range.above_least ? "greater than " : "of at least ") + in_words(range.least);
  const std::string most = (range.below_most ? "less than " : "at most ") + in_words(range.most);
  return " " + least + " and " + most;
}

std::string allowed_number(const Key& key) {
  std::string text = (key.kind == Kind::integer ? "a whole number" : "a number") + bounds(key.range);
  if (!key.unit.empty()) text += " (" + key.unit + ")";
  if (key.range.or_zero) text += ", or 0 for none";
  if (key.or_auto) text += ", or \"auto\"";
  return text;
}

std::string entries(const Key& key, const std::string& of_what) {
  return "at most " + std::to_string(key.most_entries) + " " + of_what;
}

std::string bracketed(const std::vector<Key>& members) {
  std::string text;
  for (const Key& member : members) {
    text += (text.empty() ? "[" : ", ") + member.name;
    if (!member.unit.empty()) text += " (" + member.unit + ")";
  }
  return text + "]";
}

std::string allowed_entries(const Key& list) {
  if (list.entries == Kind::tuple) return entries(list, "lists " + bracketed(list.members));
  if (list.entries == Kind::choice) return entries(list, "of " + listed(list.choices));
  return entries(list, "objects");
}

std::string allowed_one(const Key& key) {
  switch (key.kind) {
    case Kind::number:
    case Kind::integer:
      return allowed_number(key);
    case Kind::text:
      return "a text of " + entries(key, "characters without control characters");
    case Kind::identifier:
      return "a text of " + entries(key, "letters, digits, _ and -");
    case Kind::choice:
      return key.choices.size() == 1 ? "only \"" + key.choices.front() + '"'
                                     : "one of " + listed(key.choices);
    case Kind::object:
    case Kind::variant:
      return "an object";
    case Kind::tuple:
      return "a list " + bracketed(key.members);
    case Kind::list:
      return "a list of " + allowed_entries(key);
    case Kind::switch_map:
      return "an object of " + entries(key, "names, each with one of " + listed(key.choices));
  }
  return "";
}

/// Levenshtein's distance.
std::size_t edits(std::string_view one, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < other.size(); ++j) {
      const std::size_t replaced = diagonal + (one[i] == other[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string in_words(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string rounded(double number, std::string_view unit) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return std::string(text.data()) + " " + std::string(unit);
}

std::string found(const json& value) {
  switch (value.type()) {
    case json::value_t::string:
      return "the text " + quoted(value.get_ref<const std::string&>());
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case json::value_t::number_float:
      return "the number " + in_words(value.get<double>());
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
      return "the number " + value.dump();
    case json::value_t::array:
      return "a list of " + std::to_string(value.size());
    case json::value_t::object:
      return "an object";
    case json::value_t::null:
      return "null";
    default:
      return "no JSON value";
  }
}

std::string allowed(const Key& key) {
  return allowed_one(key) + (key.or_pair ? ", or a list of two of these" : "");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

std::string did_you_mean(std::string_view written, const std::vector<std::string>& names) {
  const std::string* closest = nullptr;
  std::size_t least = 3;
  for (const std::string& name : names) {
    const std::size_t distance = edits(written, name);
    if (distance < least && 2 * distance < name.size()) {
      least = distance;
      closest = &name;
    }
  }
  return closest ? "; did you mean \"" + *closest + "\"?" : "";
}

}  // namespace rouleau
