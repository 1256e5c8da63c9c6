#include "service/http/byte_range.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "service/http/request_head.h"

namespace rouleau::service {

namespace {

/// Digits alone; a number too large for 64 bits is as good as the largest.
std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::numeric_limits<std::uint64_t>::max();
  if (error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace

ByteRange parse_byte_range(std::string_view header, std::uint64_t size) {
  constexpr std::string_view unit = "bytes=";
  if (header.size() <= unit.size() || !equal_ignoring_case(header.substr(0, unit.size()), unit)) return {};
  const std::string_view spec = header.substr(unit.size());
  const auto dash = spec.find('-');
  if (dash == std::string_view::npos || spec.find(',') != std::string_view::npos) return {};
  const std::string_view left = spec.substr(0, dash);
  const std::string_view right = spec.substr(dash + 1);

  const auto last_given = number(right);
  if (!right.empty() && !last_given) return {};
  if (left.empty()) {
    if (!last_given) return {};
    if (*last_given == 0 || size == 0) return {ByteRange::Kind::unsatisfiable};
    return {ByteRange::Kind::part, size - std::min(*last_given, size), size - 1};
  }
  const auto first = number(left);
  if (!first || (last_given && *last_given < *first)) return {};
  if (*first >= size) return {ByteRange::Kind::unsatisfiable};
  return {ByteRange::Kind::part, *first, std::min(last_given.value_or(size - 1), size - 1)};
}

}  // namespace rouleau::service
