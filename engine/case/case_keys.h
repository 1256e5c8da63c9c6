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
inline constexpr std::size_t max_name_length = 200;  ///< in code points
inline constexpr double least_fill = 0.3;            ///< below it the sides of a rest shape meet

enum class Kind {
  number,
  integer,
  text,
  choice,      ///< one of `choices`
  object,      ///< of `members`
  list,        ///< of objects of `members`
  switch_map,  ///< lower_snake_case names to one of `choices`
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
  std::size_t most_entries = 0;  ///< of a list or a map; of a text its length
  std::vector<std::string> choices = {};
  std::vector<Key> members = {};
};

/// The case itself, an object.
const Key& case_key();

bool is_lower_snake_case(std::string_view name);

/// The same as a regular expression, for the schema.
inline constexpr const char* lower_snake_case_pattern = "^[a-z][a-z0-9]*(_[a-z0-9]+)*$";

}  // namespace rouleau
