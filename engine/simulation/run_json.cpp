#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/simulation/run.h"

namespace rouleau {

namespace {

const char* name_of(Ending ending) {
  switch (ending) {
    case Ending::completed:
      return "completed";
    case Ending::cell_reached_inlet:
      return "cell_reached_inlet";
    case Ending::failed:
      return "failed";
    case Ending::stopped:
      break;
  }
  return "stopped";
}

nlohmann::json to_json(const std::optional<CellDeparture>& departure) {
  if (!departure) return nullptr;
  return {{"time", departure->time}, {"outlet", departure->outlet}, {"x", departure->x}, {"y", departure->y}};
}

/// JSON knows no infinity.
nlohmann::json finite(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json shapes_json(const CellSummary& cell) {
  nlohmann::json shapes = nlohmann::json::object();
  for (int code = 0; code < cells::shape_classes; ++code) {
    if (cell.time_as[code] > 0)
      shapes[cells::name_of(static_cast<cells::ShapeClass>(code))] = cell.time_as[code];
  }
  return shapes;
}

}  // namespace

nlohmann::json to_json(const RunSummary& summary) {
  nlohmann::json cells = nlohmann::json::array();
  for (const CellSummary& cell : summary.cells) {
    cells.push_back({{"peak_velocity", cell.peak_velocity},
                     {"peak_velocity_x", cell.peak_velocity_x},
                     {"peak_tau", cell.peak_tau},
                     {"least_tau", cell.least_tau},
                     {"area_deviation", cell.area_deviation},
                     {"greatest_strain", cell.greatest_strain},
                     {"least_thickness", cell.least_thickness},
                     {"least_wall_gap", finite(cell.least_wall_gap)},
                     {"least_cell_gap", finite(cell.least_cell_gap)},
                     {"time_as", shapes_json(cell)},
                     {"departure", to_json(cell.departure)}});
  }
  nlohmann::json rejections = nlohmann::json::object();
  for (const LimitCount& cause : summary.rejections) rejections[cause.name] = cause.steps;
  nlohmann::json watched = nlohmann::json::object();
  for (const WatchedQuantity& quantity : summary.watched) {
    watched[quantity.name] = {
        {"worst", finite(quantity.worst)}, {"bound", quantity.bound}, {"unit", quantity.unit}};
  }
  nlohmann::json bound = nlohmann::json::object();
  for (const LimitCount& limit : summary.step_limits) bound[limit.name] = limit.steps;
  nlohmann::json times = nlohmann::json::array();
  for (const EffectTime& time : summary.effect_times) {
    times.push_back(
        {{"name", time.name}, {"seconds", time.seconds}, {"rounds", time.rounds}, {"awake", time.awake}});
  }
  nlohmann::json findings = nlohmann::json::object();
  for (const Finding& finding : summary.findings) {
    findings[finding.name] = {{"value", finite(finding.value)}, {"unit", finding.unit}};
  }
  nlohmann::json refinements = nlohmann::json::array();
  for (const Refinement& refinement : summary.refinements) {
    refinements.push_back(
        {{"time", refinement.time}, {"cell", refinement.cell}, {"spacing", refinement.spacing}});
  }
  nlohmann::json json = {{"ending", name_of(summary.ending)},
                         {"reason", summary.reason},
                         {"simulated_time", summary.simulated_time},
                         {"steps", summary.steps},
                         {"rejected_steps", summary.rejected_steps},
                         {"rejections", rejections},
                         {"step_limits", bound},
                         {"least_time_step", summary.least_time_step},
                         {"refinements", refinements},
                         {"wall_time", summary.wall_time},
                         {"steps_per_second", summary.steps_per_second},
                         {"cells", cells},
                         {"volume_in", summary.volume_in},
                         {"volume_out", summary.volume_out},
                         {"volume_mismatch", summary.volume_mismatch},
                         {"peak_fluid_speed", summary.peak_fluid_speed},
                         {"watched", watched},
                         {"warnings", summary.warnings},
                         {"contact_steps", summary.contact_steps},
                         {"wrong_side", summary.wrong_side},
                         {"viscosity_iterations", summary.viscosity_iterations},
                         {"pressure_iterations", summary.pressure_iterations},
                         {"findings", findings},
                         {"effect_times", times}};
  if (summary.poiseuille_deviation >= 0) {
    json["poiseuille_deviation"] = summary.poiseuille_deviation;
    json["poiseuille_deviation_worst"] = summary.poiseuille_deviation_worst;
  }
  return json;
}

}  // namespace rouleau
