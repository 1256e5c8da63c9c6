#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case_keys.h"

namespace rouleau {

/// A number as short as it reads back.
std::string in_words(double number);
/// A computed number with its unit, to three digits.
std::string rounded(double number, std::string_view unit);

/// What a value is: "the text \"plug\"", "the number 3.9", "a list".
std::string found(const nlohmann::json& value);
/// What a key may be: "a number greater than 0 and less than 1 (m)".
std::string allowed(const Key& key);

/// "a, b, c"
std::string listed(const std::vector<std::string>& names);
/// `; did you mean "length"?` if one of the names is close, or "".
std::string did_you_mean(std::string_view written, const std::vector<std::string>& names);

}  // namespace rouleau
