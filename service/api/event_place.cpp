#include "service/api/event_place.h"

#include <charconv>

#include "engine/simulation/run.h"

namespace rouleau::service {

namespace {

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string to_event_id(const EventPlace& place) {
  std::string id = std::to_string(place.rows) + '@' + engine_version();
  if (place.ended) id += '@' + std::to_string(*place.ended);
  return id;
}

EventPlace parse_event_id(std::string_view id) {
  const auto first = id.find('@');
  if (first == std::string_view::npos) return {};
  const auto rows = whole_number<std::size_t>(id.substr(0, first));
  id.remove_prefix(first + 1);
  const auto second = id.find('@');
  if (!rows || id.substr(0, second) != engine_version()) return {};
  EventPlace place{*rows, {}};
  if (second != std::string_view::npos) place.ended = whole_number<storage::TimeMs>(id.substr(second + 1));
  return place;
}

}  // namespace rouleau::service
