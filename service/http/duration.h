#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace rouleau::service {

/// "20s", "500ms", "2m" or plain seconds; none if it is not one of these or longer than a day.
std::optional<std::chrono::milliseconds> parse_duration(std::string_view text);

}  // namespace rouleau::service
