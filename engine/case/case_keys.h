#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace rouleau {

inline constexpr std::size_t max_thrombi = 64;
inline constexpr std::size_t max_cells = 64;
inline constexpr std::size_t max_effects = 64;
inline constexpr std::size_t max_probes = 32;
inline constexpr std::size_t max_waveform_points = 10'000;
inline constexpr std::size_t max_name_length = 200;  ///< in code points
inline constexpr std::size_t max_probe_name_length = 64;
inline constexpr double least_fill = 0.3;  ///< below it the sides of a rest shape meet

enum class Kind {
  number,
  integer,
  text,
  identifier,  ///< a text of letters, digits, _ and -
  choice,      ///< one of `choices`
  object,      ///< of `members`
  variant,     ///< an object whose first member, a choice, says which of `variants` it is
  tuple,       ///< a list of exactly `members`, in their order
  list,        ///< of `entries`
  switch_map,  ///< lower_snake_case names to one of `choices` or an object of numbers
};

/// Bounds of a number; inclusive unless said otherwise.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;  ///< `least` itself is not allowed
  bool below_most = false;   ///< `most` itself is not allowed
  bool or_zero = false;      ///< 0 is allowed although it is out of bounds

  bool holds(double value) const;
};

struct Key;

/// The members that an object has beside those of every variant where its first member says `choice`.
struct Variant {
  std::string choice;
  std::vector<Key> members;
};

/// One key of a case: all that the reader checks and all that the JSON Schema says.
struct Key {
  std::string name;
  Kind kind = Kind::number;
  std::string description;       ///< one sentence
  std::string unit = {};         ///< SI; "" where it has none
  Range range = {};              ///< of a number or an integer
  nlohmann::json fallback = {};  ///< its default; null where it has none of its own
  bool required = false;
  bool or_auto = false;          ///< of a number: the word "auto" is allowed too
  bool or_pair = false;          ///< of a number or an object: a list of two of them is allowed too
  std::size_t most_entries = 0;  ///< of a list or a map; of a text its length
  Kind entries = Kind::object;   ///< of a list: object or tuple (of `members`) or choice (of `choices`)
  bool distinct = false;         ///< of a list: no entry twice
  std::vector<std::string> choices = {};
  std::vector<Key> members = {};
  std::vector<Variant> variants = {};
};

/// What each entry of a list must be.
Key entry_of(const Key& list);

/// All members that `object` allows: those of every variant and those of `variant`.
std::vector<Key> members_of(const Key& object, const Variant& variant);

/// The case itself, an object.
const Key& case_key();

bool is_lower_snake_case(std::string_view name);
/// Letters, digits, _ and -, at least one of them.
bool is_identifier(std::string_view name);

/// The same as regular expressions, for the schema.
inline constexpr const char* lower_snake_case_pattern = "^[a-z][a-z0-9]*(_[a-z0-9]+)*$";
inline constexpr const char* identifier_pattern = "^[A-Za-z0-9_-]+$";

}  // namespace rouleau
