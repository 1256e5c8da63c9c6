#include "service/sweep/sweep_body.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/case/faults.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

constexpr std::size_t longest_name = 256;
constexpr std::size_t most_axes = 16;
// What all points together may hold, so that a large case is not multiplied into gigabytes.
constexpr std::size_t most_bytes = 64 << 20;

std::optional<double> number_of(const nlohmann::json& axis, const char* key, const std::string& pointer,
                                std::vector<Fault>& faults) {
  const auto found = axis.find(key);
  if (found != axis.end() && found->is_number() && std::isfinite(found->get<double>())) {
    return found->get<double>();
  }
  faults.push_back({pointer + '/' + key, found == axis.end() ? "is missing" : "must be a number"});
  return std::nullopt;
}

/// 0 if there is none.
std::uint64_t count_of(const nlohmann::json& axis) {
  const auto found = axis.find("count");
  if (found == axis.end() || !found->is_number_integer()) return 0;
  // What is no unsigned number may be one all the same, if no parser made it.
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  return static_cast<std::uint64_t>(std::max<std::int64_t>(found->get<std::int64_t>(), 0));
}

std::vector<nlohmann::json> read_span(const nlohmann::json& axis, const std::string& pointer,
                                      std::size_t most_points, std::vector<Fault>& faults) {
  const auto from = number_of(axis, "from", pointer, faults);
  const auto to = number_of(axis, "to", pointer, faults);
  const auto count = count_of(axis);
  if (count == 0) faults.push_back({pointer + "/count", "must be a whole number of at least 1"});
  if (!from || !to || count == 0) return {};
  // One more than may be is as far too many as whatever else was asked for.
  const auto values = evenly_spaced(*from, *to, std::min<std::uint64_t>(count, most_points + 1));
  return {values.begin(), values.end()};
}

void check_keys(const nlohmann::json& axis, const std::string& pointer, std::vector<Fault>& faults) {
  for (const auto& [key, value] : axis.items()) {
    if (key != "pointer" && key != "values" && key != "from" && key != "to" && key != "count") {
      faults.push_back(
          {pointer_to(pointer, key), "unknown key; allowed: pointer, and values or from, to, count"});
    }
  }
}

Axis read_axis(const nlohmann::json& json, const std::string& pointer, std::size_t most_points,
               std::vector<Fault>& faults) {
  Axis axis;
  if (!json.is_object()) {
    faults.push_back({pointer, "must be an object"});
    return axis;
  }
  check_keys(json, pointer, faults);
  if (const auto found = json.find("pointer"); found != json.end() && found->is_string()) {
    axis.pointer = *found;
  }
  if (axis.pointer.empty() || axis.pointer.front() != '/') {
    faults.push_back(
        {pointer + "/pointer", "must be a JSON Pointer into the case, such as /vessel/diameter"});
  }
  const auto values = json.find("values");
  const bool spans = json.contains("from") || json.contains("to") || json.contains("count");
  if (values == json.end()) {
    axis.values = read_span(json, pointer, most_points, faults);
  } else if (spans) {
    faults.push_back({pointer, "has values as well as from, to or count; give either"});
  } else if (!values->is_array() || values->empty()) {
    faults.push_back({pointer + "/values", "must be an array of at least one value"});
  } else {
    axis.values.assign(values->begin(), values->end());
  }
  return axis;
}

/// Whether what one names is what the other names, or a part of it.
bool overlap(const std::string& one, const std::string& other) {
  const std::string& longer = one.size() > other.size() ? one : other;
  const std::string& shorter = one.size() > other.size() ? other : one;
  return longer.starts_with(shorter) && (longer.size() == shorter.size() || longer[shorter.size()] == '/');
}

void check_together(const SweepBody& sweep, std::vector<Fault>& faults) {
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    for (std::size_t b = 0; b < a; ++b) {
      if (!axis.pointer.empty() && !sweep.axes[b].pointer.empty() &&
          overlap(axis.pointer, sweep.axes[b].pointer)) {
        faults.push_back({pointer_to("/axes", a) + "/pointer",
                          "names what axis " + std::to_string(b) + " varies already"});
      }
    }
    if (sweep.mode == SweepMode::zip && axis.values.size() != sweep.axes.front().values.size()) {
      faults.push_back({pointer_to("/axes", a), "has " + std::to_string(axis.values.size()) +
                                                    " values where the first axis has " +
                                                    std::to_string(sweep.axes.front().values.size()) +
                                                    "; with mode zip all have as many"});
    }
  }
}

void read_axes(const nlohmann::json& document, std::size_t most_points, SweepBody& sweep,
               std::vector<Fault>& faults) {
  const auto axes = document.find("axes");
  if (axes == document.end() || !axes->is_array() || axes->empty() || axes->size() > most_axes) {
    faults.push_back({"/axes", "must be an array of 1 to " + std::to_string(most_axes) + " axes"});
    return;
  }
  const std::size_t before = faults.size();
  for (std::size_t a = 0; a < axes->size(); ++a) {
    sweep.axes.push_back(read_axis((*axes)[a], pointer_to("/axes", a), most_points, faults));
  }
  if (faults.size() == before) check_together(sweep, faults);
}

void read_name_and_mode(const nlohmann::json& document, SweepBody& sweep, std::vector<Fault>& faults) {
  if (const auto name = document.find("name"); name != document.end()) {
    if (name->is_string() && name->get_ref<const std::string&>().size() <= longest_name) {
      sweep.name = *name;
    } else {
      faults.push_back({"/name", "must be a text of at most " + std::to_string(longest_name) + " bytes"});
    }
  } else if (const auto scene = document.find("case"); scene != document.end() && scene->is_object()) {
    if (const auto own = scene->find("name"); own != scene->end() && own->is_string()) {
      sweep.name = own->get<std::string>().substr(0, longest_name);
    }
  }
  if (const auto mode = document.find("mode"); mode != document.end()) {
    if (*mode != "grid" && *mode != "zip") faults.push_back({"/mode", "must be \"grid\" or \"zip\""});
    sweep.mode = *mode == "zip" ? SweepMode::zip : SweepMode::grid;
  }
}

/// Bytes of a case with the longest value on each axis, at most.
std::size_t longest_point(const SweepBody& sweep) {
  std::size_t bytes = dump(sweep.scene).size();
  for (const Axis& axis : sweep.axes) {
    std::size_t longest = 0;
    for (const nlohmann::json& value : axis.values) longest = std::max(longest, dump(value).size());
    bytes += longest;
  }
  return bytes;
}

}  // namespace

SweepBody read_sweep(const nlohmann::json& document, std::size_t most_points,
                     std::initializer_list<std::string_view> others, std::vector<Fault> faults) {
  if (!document.is_object()) {
    throw Problem(problems::invalid_request, "the body must be an object", {{"", "must be an object"}});
  }
  for (const auto& [key, value] : document.items()) {
    const bool known = key == "case" || key == "axes" || key == "mode" || key == "name";
    if (!known && std::find(others.begin(), others.end(), key) == others.end()) {
      faults.push_back(
          {pointer_to("", key), "unknown key; allowed: case, axes, mode, name, priority, labels, fresh"});
    }
  }
  SweepBody sweep;
  read_name_and_mode(document, sweep, faults);
  read_axes(document, most_points, sweep, faults);
  if (const auto scene = document.find("case"); scene != document.end()) {
    sweep.scene = *scene;
  } else {
    faults.push_back({"/case", "is missing"});
  }
  if (!faults.empty()) throw Problem(problems::invalid_request, "the body is not a sweep", std::move(faults));

  const auto points = point_count(sweep.axes, sweep.mode, most_points);
  if (!points) {
    throw Problem(problems::sweep_too_large,
                  "the axes span more than " + std::to_string(most_points) + " points");
  }
  if (*points > most_bytes / longest_point(sweep)) {
    throw Problem(problems::sweep_too_large, "the case is too long for " + std::to_string(*points) +
                                                 " points: together they have more than " +
                                                 std::to_string(most_bytes >> 20) + " MiB");
  }
  sweep.points = *points;
  return sweep;
}

}  // namespace rouleau::service
