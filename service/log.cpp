#include "service/log.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace rouleau::service::log {

namespace {

std::string json_string(std::string_view value) {
  return nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string quoted_if_needed(const std::string& value) {
  const bool plain = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_.:/+").find(c) != std::string_view::npos;
  });
  if (plain) return value;
  return json_string(value);
}

// Set before there is a second thread.
Format chosen = Format::text;

void write(spdlog::level::level_enum level, std::string_view event, Fields fields) {
  if (spdlog::should_log(level)) {
    spdlog::log(level, "{}", chosen == Format::json ? format_members(event, fields) : format(event, fields));
  }
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

std::string format_members(std::string_view event, Fields fields) {
  std::string members = "\"event\":" + json_string(event);
  for (const auto& [key, value] : fields) members += ',' + json_string(key) + ':' + json_string(value);
  return members;
}

void set_up(const std::string& level, Format form) {
  chosen = form;
  auto logger = spdlog::stderr_logger_mt("rouleau");
  logger->set_pattern(form == Format::json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l",%v})"
                                           : "time=%Y-%m-%dT%H:%M:%S.%eZ level=%l %v",
                      spdlog::pattern_time_type::utc);
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
