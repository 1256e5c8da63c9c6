#include "engine/case/bounded_json.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"

namespace rouleau {
namespace {

using nlohmann::json;

/// The end of what was read, if it can be shown: printable ASCII and not the whole document.
std::string near(std::string_view read) {
  constexpr std::size_t longest = 40;
  const std::string_view end = read.substr(read.size() - std::min(read.size(), longest));
  const bool printable = std::all_of(end.begin(), end.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (end.empty() || !printable) return "";
  return " near `" + std::string(end) + "`";
}

/// Whether the parser stopped in NaN, Infinity or the like.
bool not_finite(std::string_view read, std::string_view what) {
  constexpr std::array starts = {"N", "I", "na", "i", "-N", "-I", "-n", "-i"};
  const bool literal = what.find("invalid literal") != std::string_view::npos ||
                       what.find("expected digit after '-'") != std::string_view::npos;
  return literal && std::any_of(starts.begin(), starts.end(),
                                [read](std::string_view start) { return read.ends_with(start); });
}

/// What is wrong, in words. The parser's own message may quote a megabyte of input or bytes that are no
/// UTF-8, so none of it is passed on.
std::string complaint(std::string_view read, const json::exception& error) {
  constexpr int number_overflow = 406;
  const std::string_view what = error.what();
  const auto says = [what](std::string_view words) { return what.find(words) != std::string_view::npos; };
  if (error.id == number_overflow) return "a number too large to hold" + near(read);
  if (says("UTF-8")) return "text that is not valid UTF-8";
  if (says("surrogate")) return "half of a surrogate pair in a string";
  if (says("unexpected end of input") || says("missing closing quote")) {
    return "the text ends before the document does";
  }
  if (says("expected end of input")) return "something after the end of the document" + near(read);
  if (not_finite(read, what)) return "NaN and Infinity are no JSON numbers; a finite number is allowed";
  return "not valid JSON" + near(read);
}

std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1);
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

/// Builds the document while it watches depth and keys; `parse_error` and the bounds end the parse with
/// a fault.
class BoundedBuilder : public nlohmann::json_sax<json> {
 public:
  BoundedBuilder(std::string_view text, Faults& faults) : text_(text), faults_(faults) {}

  json take() { return std::move(root_); }

  bool null() override { return place(nullptr); }
  bool boolean(bool value) override { return place(value); }
  bool number_integer(number_integer_t value) override { return place(value); }
  bool number_unsigned(number_unsigned_t value) override { return place(value); }
  bool number_float(number_float_t value, const string_t&) override { return place(value); }
  bool string(string_t& value) override { return place(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (name.size() > max_key_bytes) {
      faults_.add(here(), "a key of " + std::to_string(name.size()) + " bytes; at most " +
                              std::to_string(max_key_bytes) + " are allowed");
      return false;
    }
    Level& level = levels_.back();
    if (level.container->contains(name)) {
      faults_.add(pointer_to(container_pointer(), name),
                  "the key \"" + name + "\" is given more than once; once is allowed");
    }
    level.key = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const json::exception& error) override {
    faults_.add(here(), line_and_column(text_, position) + ": " + complaint(token, error));
    return false;
  }

 private:
  struct Level {
    json* container;
    std::string key;  ///< the one being read, of an object
  };

  json& slot() {
    if (levels_.empty()) return root_;
    const Level& level = levels_.back();
    if (level.container->is_object()) return (*level.container)[level.key];
    return level.container->emplace_back();
  }

  bool place(json value) {
    slot() = std::move(value);
    return true;
  }

  bool open(json empty) {
    if (levels_.size() >= max_case_depth) {
      faults_.add(here(), "nested more than " + std::to_string(max_case_depth) + " levels deep");
      return false;
    }
    json& container = slot();
    container = std::move(empty);
    levels_.push_back({&container, {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string pointer(std::size_t depth) const {
    std::string result;
    for (std::size_t k = 0; k < depth; ++k) {
      const Level& level = levels_[k];
      if (level.container->is_object()) {
        result = pointer_to(result, level.key);
      } else {
        const std::size_t read = level.container->size();
        result = pointer_to(result, k + 1 < levels_.size() ? read - 1 : read);
      }
    }
    return result;
  }

  std::string container_pointer() const { return pointer(levels_.empty() ? 0 : levels_.size() - 1); }

  /// The value being read: below an object whose first key has not come yet, the object itself.
  std::string here() const {
    const bool no_key =
        !levels_.empty() && levels_.back().container->is_object() && levels_.back().key.empty();
    return no_key ? container_pointer() : pointer(levels_.size());
  }

  std::string_view text_;
  Faults& faults_;
  json root_;
  std::vector<Level> levels_;
};

}  // namespace

json parse_bounded(std::string_view text, Faults& faults) {
  if (text.size() > max_case_bytes) {
    faults.add("", "the text has " + std::to_string(text.size()) + " bytes; at most " +
                       std::to_string(max_case_bytes) + " are allowed");
    faults.raise();
  }
  // The parser takes a zero byte for the end of its input and would never see what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    faults.add("", line_and_column(text, zero + 1) + ": a zero byte, which JSON does not have");
    faults.raise();
  }
  BoundedBuilder builder(text, faults);
  if (!json::sax_parse(text.begin(), text.end(), &builder)) faults.raise();
  return builder.take();
}

json parse_json(std::string_view text) {
  Faults faults;
  json document = parse_bounded(text, faults);
  faults.raise();
  return document;
}

}  // namespace rouleau
