#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

/// One line an event on standard error, `event="..." key=value ...`, so that both people and programs can
/// search it; or a JSON object a line.
namespace rouleau::service::log {

using Field = std::pair<std::string_view, std::string>;
using Fields = std::initializer_list<Field>;

enum class Format { text, json };

/// @param level "debug", "info", "warn", "error" or "off"
void set_up(const std::string& level, Format form = Format::text);

void debug(std::string_view event, Fields fields = {});
void info(std::string_view event, Fields fields = {});
void warn(std::string_view event, Fields fields = {});
void error(std::string_view event, Fields fields = {});

/// The line without its time and level: values that hold more than plain characters are quoted and escaped,
/// so that no input can forge a line.
std::string format(std::string_view event, Fields fields);
/// The same as the members of a JSON object.
std::string format_members(std::string_view event, Fields fields);

}  // namespace rouleau::service::log
