#include "service/http/duration.h"

#include <charconv>

namespace rouleau::service {

std::optional<std::chrono::milliseconds> parse_duration(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (error != std::errc{} || !(value >= 0)) return std::nullopt;
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  double milliseconds = 0;
  if (unit == "ms") {
    milliseconds = value;
  } else if (unit == "s" || unit.empty()) {
    milliseconds = 1e3 * value;
  } else if (unit == "m") {
    milliseconds = 60e3 * value;
  } else {
    return std::nullopt;
  }
  const std::chrono::hours day(24);
  if (!(milliseconds <= static_cast<double>(std::chrono::milliseconds(day).count()))) return std::nullopt;
  return std::chrono::milliseconds(static_cast<std::chrono::milliseconds::rep>(milliseconds));
}

}  // namespace rouleau::service
