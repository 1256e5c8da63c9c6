#include "service/log.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace rouleau::service::log {

namespace {

std::string quoted_if_needed(const std::string& value) {
  const bool plain = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_.:/+").find(c) != std::string_view::npos;
  });
  if (plain) return value;
  return nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

void write(spdlog::level::level_enum level, std::string_view event, Fields fields) {
  if (spdlog::should_log(level)) spdlog::log(level, "{}", format(event, fields));
}

}  // namespace

std::string format(std::string_view event, Fields fields) {
  std::string line = "event=" + quoted_if_needed(std::string(event));
  for (const auto& [key, value] : fields) {
    line += ' ';
    line += key;
    line += '=' + quoted_if_needed(value);
  }
  return line;
}

void set_up(const std::string& level) {
  auto logger = spdlog::stderr_logger_mt("rouleau");
  logger->set_pattern("time=%Y-%m-%dT%H:%M:%S.%eZ level=%l %v", spdlog::pattern_time_type::utc);
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

void debug(std::string_view event, Fields fields) {
  write(spdlog::level::debug, event, fields);
}
void info(std::string_view event, Fields fields) {
  write(spdlog::level::info, event, fields);
}
void warn(std::string_view event, Fields fields) {
  write(spdlog::level::warn, event, fields);
}
void error(std::string_view event, Fields fields) {
  write(spdlog::level::err, event, fields);
}

}  // namespace rouleau::service::log
