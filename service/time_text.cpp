#include "service/time_text.h"

#include <chrono>

#include <fmt/chrono.h>

namespace rouleau::service {

std::string format_time(storage::TimeMs time) {
  const std::time_t seconds = time / 1000;
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), time % 1000);
}

}  // namespace rouleau::service
