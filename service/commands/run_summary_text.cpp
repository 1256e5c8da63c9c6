#include "service/commands/run_summary_text.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/commands/progress_line.h"

namespace rouleau::service {

namespace {

double number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string describe_shape(const nlohmann::json& cell) {
  std::string list;
  if (const auto shapes = cell.find("time_as"); shapes != cell.end()) {
    for (const auto& [name, share] : shapes->items()) {
      list += fmt::format("{}{} {:.0f} %", list.empty() ? "" : ", ", name, 100 * share.get<double>());
    }
  }
  if (list.empty()) return list;
  list = fmt::format("  {} of the time; {:.3g} um thick and {:.3g} um off walls at the least", list,
                     1e6 * number(cell, "least_thickness"), 1e6 * number(cell, "least_wall_gap"));
  const auto gap = cell.find("least_cell_gap");
  if (gap != cell.end() && gap->is_number()) {
    list += fmt::format(", {:.3g} um off other cells", 1e6 * gap->get<double>());
  }
  return list + "\n";
}

std::string describe_cells(const nlohmann::json& cells) {
  std::string text;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& cell = cells[k];
    text += fmt::format(
        "cell {}: peak velocity {:.4g} mm/s at x = {:.2f} um; tau {:.4f} to {:.4f}; area kept within {:.3f} "
        "%\n",
        k, 1e3 * number(cell, "peak_velocity"), 1e6 * number(cell, "peak_velocity_x"),
        number(cell, "least_tau"), number(cell, "peak_tau"), 100 * number(cell, "area_deviation"));
    text += describe_shape(cell);
    if (const auto left = cell.find("departure"); left != cell.end() && left->is_object()) {
      text +=
          fmt::format("cell {} left through outlet {} at {:.4g} ms, last at x = {:.2f} um, y = {:.2f} um\n",
                      k, number(*left, "outlet"), 1e3 * number(*left, "time"), 1e6 * number(*left, "x"),
                      1e6 * number(*left, "y"));
    }
  }
  return text;
}

/// Nothing where every step was the planned one.
std::string describe_step_limits(const nlohmann::json& summary) {
  const auto bound = summary.find("step_limits");
  if (bound == summary.end()) return "";
  std::string held;
  for (const auto& [limit, steps] : bound->items()) {
    if (limit == "planned" || limit == "end") continue;
    held += fmt::format("{}{} by {}", held.empty() ? "" : ", ", steps.get<long>(), limit);
  }
  if (held.empty()) return "";
  return fmt::format("steps held back: {}; {:.0f} taken again; the smallest {:.3g} us\n", held,
                     number(summary, "rejected_steps"), 1e6 * number(summary, "least_time_step"));
}

/// The worst of each watched quantity beside its bound, what was taken again for it, and warnings.
std::string describe_watched(const nlohmann::json& summary) {
  std::string text, list;
  if (const auto watched = summary.find("watched"); watched != summary.end()) {
    for (const auto& [name, quantity] : watched->items()) {
      const std::string unit = quantity.value("unit", "1");
      list +=
          fmt::format("{}{} {:.3g} of {:.3g}{}", list.empty() ? "" : ", ", name, number(quantity, "worst"),
                      number(quantity, "bound"), unit == "1" ? "" : " " + unit);
    }
  }
  if (!list.empty()) text += fmt::format("watched, worst of bound: {}\n", list);
  list.clear();
  if (const auto causes = summary.find("rejections"); causes != summary.end()) {
    for (const auto& [cause, steps] : causes->items()) {
      list += fmt::format("{}{} by {}", list.empty() ? "" : ", ", steps.get<long>(), cause);
    }
  }
  if (!list.empty()) text += fmt::format("steps taken again: {}\n", list);
  if (const auto warnings = summary.find("warnings"); warnings != summary.end()) {
    for (const auto& warning : *warnings) text += fmt::format("warning: {}\n", warning.get<std::string>());
  }
  return text;
}

/// The share of its turns in which an effect was awake, where it slept in some.
std::string describe_sleep(const nlohmann::json& effect) {
  const double rounds = number(effect, "rounds"), awake = number(effect, "awake");
  return awake < rounds ? fmt::format("  awake {:.3g} % of the time", 100 * awake / rounds) : "";
}

std::string describe_effect_times(nlohmann::json times) {
  std::sort(times.begin(), times.end(), [](const nlohmann::json& a, const nlohmann::json& b) {
    return number(a, "seconds") > number(b, "seconds");
  });
  double total = 0;
  for (const auto& effect : times) total += number(effect, "seconds");
  std::string text;
  for (const auto& effect : times) {
    const double seconds = number(effect, "seconds");
    text += fmt::format("  {:28} {:8.2f} s {:5.1f} %{}\n", effect.value("name", ""), seconds,
                        total > 0 ? 100 * seconds / total : 0.0, describe_sleep(effect));
  }
  return text.empty() ? text : "time per effect:\n" + text;
}

/// What observers that the case asked for found out.
std::string describe_findings(const nlohmann::json& findings) {
  std::string text;
  for (const auto& [name, finding] : findings.items()) {
    const std::string unit = finding.value("unit", "1");
    text += fmt::format("{}: {:.4g}{}\n", name, number(finding, "value"), unit == "1" ? "" : " " + unit);
  }
  return text;
}

std::string describe_refinements(const nlohmann::json& refinements) {
  std::string text;
  for (const auto& refinement : refinements) {
    text += fmt::format("at {:.4g} ms the membrane of cell {:.0f} got new nodes, at a spacing of {:.3g} um\n",
                        1e3 * number(refinement, "time"), number(refinement, "cell"),
                        1e6 * number(refinement, "spacing"));
  }
  return text;
}

}  // namespace

std::string describe_summary(const nlohmann::json& summary) {
  std::string text = fmt::format("{}\n{:.4g} ms simulated in {}: {:.0f} steps, {:.0f} steps/s\n",
                                 summary.value("reason", ""), 1e3 * number(summary, "simulated_time"),
                                 format_time_left(number(summary, "wall_time")), number(summary, "steps"),
                                 number(summary, "steps_per_second"));
  if (const auto cells = summary.find("cells"); cells != summary.end()) text += describe_cells(*cells);
  // A vessel without openings has none of these.
  if (number(summary, "volume_in") != 0 || number(summary, "volume_out") != 0) {
    text += fmt::format("conservation: {:.4g} um2 in, {:.4g} um2 out, differing by {:.3f} %\n",
                        1e12 * number(summary, "volume_in"), 1e12 * number(summary, "volume_out"),
                        100 * number(summary, "volume_mismatch"));
  }
  if (summary.contains("poiseuille_deviation")) {
    text += fmt::format(
        "deviation from the parabola (eq. 22), last half: {:.4f} % in the mean, {:.4f} % at worst\n",
        100 * number(summary, "poiseuille_deviation"), 100 * number(summary, "poiseuille_deviation_worst"));
  }
  if (const double through = number(summary, "wrong_side"); through > 0) {
    text += fmt::format("{:.0f} particles slipped through a membrane and were put back\n", through);
  }
  if (const auto changes = summary.find("refinements"); changes != summary.end()) {
    text += describe_refinements(*changes);
  }
  text += describe_step_limits(summary);
  text += describe_watched(summary);
  text += fmt::format("peak fluid speed {:.4g} mm/s\n", 1e3 * number(summary, "peak_fluid_speed"));
  if (const auto findings = summary.find("findings"); findings != summary.end()) {
    text += describe_findings(*findings);
  }
  if (const auto times = summary.find("effect_times"); times != summary.end())
    text += describe_effect_times(*times);
  return text;
}

}  // namespace rouleau::service
