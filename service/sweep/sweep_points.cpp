#include "service/sweep/sweep_points.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/case/case_json.h"
#include "engine/case/faults.h"
#include "engine/plan/plan.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

// Every bad point is named; beyond this many faults each by its first alone.
constexpr std::size_t most_listed_faults = 10'000;

std::optional<Pointer> parse_pointer(const std::string& text) {
  try {
    return Pointer(text);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

bool exists(const Json& document, const Pointer& pointer) {
  try {
    return document.contains(pointer);
  } catch (const Json::exception&) {  // such as a text where an array's index must stand
    return false;
  }
}

/// Puts a value where a case has one only by default: the objects on the way are made with nothing else in
/// them, so that all other defaults stay what they are; an array that was left out is taken whole.
void put(Json& document, const Json& resolved, const Pointer& pointer, const Json& value) {
  if (pointer.empty()) {
    document = value;
    return;
  }
  const Pointer parent = pointer.parent_pointer();
  if (!exists(document, parent)) {
    put(document, resolved, parent, resolved.at(parent).is_array() ? resolved.at(parent) : Json::object());
  } else if (!document.at(parent).is_structured()) {
    put(document, resolved, parent, resolved.at(parent));  // given short, such as "on" for an effect
  }
  document[pointer] = value;
}

bool can_put(Json document, const Json& resolved, const Pointer& pointer) {
  if (!exists(document, pointer) && !exists(resolved, pointer)) return false;
  try {
    put(document, resolved, pointer, nullptr);
    return true;
  } catch (const Json::exception&) {  // it is of another form where it is given
    return false;
  }
}

/// The case as it is resolved at the first point, for whatever has a default there.
Json resolved_form(const SweepBody& sweep, const std::vector<std::optional<Pointer>>& pointers) {
  Json document = sweep.scene;
  for (std::size_t a = 0; a < pointers.size(); ++a) {
    if (pointers[a] && exists(document, *pointers[a])) document[*pointers[a]] = sweep.axes[a].values.front();
  }
  try {
    return to_json(read_case(document, check_effects));
  } catch (const CaseError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, "/case");
    throw Problem(problems::invalid_case, "the case of the sweep has faults at its first point",
                  std::move(faults));
  }
}

/// @throws Problem if one names nothing
std::vector<Pointer> find_places(const SweepBody& sweep, Json& resolved) {
  std::vector<std::optional<Pointer>> parsed;
  for (const Axis& axis : sweep.axes) parsed.push_back(parse_pointer(axis.pointer));
  const bool all_given = std::all_of(parsed.begin(), parsed.end(), [&](const auto& pointer) {
    return pointer && exists(sweep.scene, *pointer);
  });
  if (!all_given) resolved = resolved_form(sweep, parsed);

  std::vector<Pointer> places;
  std::vector<Fault> faults;
  for (std::size_t a = 0; a < parsed.size(); ++a) {
    if (parsed[a] && can_put(sweep.scene, resolved, *parsed[a])) {
      places.push_back(*parsed[a]);
    } else {
      faults.push_back(
          {pointer_to("/axes", a) + "/pointer",
           "names nothing that the case has, as it is given or by default; give it a value there"});
    }
  }
  if (!faults.empty()) {
    throw Problem(problems::invalid_case, "an axis varies what the case does not have", std::move(faults));
  }
  return places;
}

std::string describe_values(const SweepBody& sweep, const std::vector<std::size_t>& choice) {
  constexpr std::size_t longest = 80;
  std::string text;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    std::string value = dump(sweep.axes[a].values[choice[a]]);
    if (value.size() > longest) value = value.substr(0, longest) + "...";
    text += (a == 0 ? "" : ", ") + sweep.axes[a].pointer + " = " + value;
  }
  return text;
}

/// The faults of all points.
class BadPoints {
 public:
  explicit BadPoints(const SweepBody& sweep) : sweep_(sweep) {}

  void add(std::size_t point, const std::vector<std::size_t>& choice, const CaseError& error) {
    ++points_;
    const std::string which =
        "point " + std::to_string(point) + " (" + describe_values(sweep_, choice) + "): ";
    for (const Fault& fault : error.faults()) {
      faults_.push_back({"/case" + fault.pointer, which + fault.message});
      if (faults_.size() > most_listed_faults) break;
    }
  }

  void raise() {
    if (points_ == 0) return;
    throw Problem(problems::invalid_case,
                  std::to_string(points_) + " of " + std::to_string(sweep_.points) +
                      (sweep_.points == 1 ? " point has faults" : " points have faults"),
                  std::move(faults_));
  }

 private:
  const SweepBody& sweep_;
  std::size_t points_ = 0;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<SweepPoint> expand(const SweepBody& sweep) {
  Json resolved;
  const std::vector<Pointer> places = find_places(sweep, resolved);
  std::vector<SweepPoint> points;
  points.reserve(sweep.points);
  BadPoints bad(sweep);
  for (std::size_t k = 0; k < sweep.points; ++k) {
    SweepPoint point;
    point.choice = choice_at(sweep.axes, sweep.mode, k);
    Json document = sweep.scene;
    for (std::size_t a = 0; a < places.size(); ++a) {
      put(document, resolved, places[a], sweep.axes[a].values[point.choice[a]]);
    }
    try {
      point.resolved = read_case(document, check_effects);
      point.given = dump(document);
      points.push_back(std::move(point));
    } catch (const CaseError& error) {
      bad.add(k, point.choice, error);
    }
  }
  bad.raise();
  return points;
}

std::vector<Json> values_at(const SweepBody& sweep, const std::vector<std::size_t>& choice) {
  std::vector<Json> values;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) values.push_back(sweep.axes[a].values[choice[a]]);
  return values;
}

}  // namespace rouleau::service
