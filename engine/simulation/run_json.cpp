#include <nlohmann/json.hpp>

#include "engine/simulation/run.h"

namespace rouleau {

namespace {

const char* name_of(Ending ending) {
  switch (ending) {
    case Ending::completed:
      return "completed";
    case Ending::cell_reached_outlet:
      return "cell_reached_outlet";
    case Ending::stopped:
      break;
  }
  return "stopped";
}

}  // namespace

nlohmann::json to_json(const RunSummary& summary) {
  nlohmann::json cells = nlohmann::json::array();
  for (const CellSummary& cell : summary.cells) {
    cells.push_back({{"peak_velocity", cell.peak_velocity},
                     {"peak_velocity_x", cell.peak_velocity_x},
                     {"peak_tau", cell.peak_tau},
                     {"least_tau", cell.least_tau},
                     {"area_deviation", cell.area_deviation}});
  }
  nlohmann::json bound = nlohmann::json::object();
  for (const LimitCount& limit : summary.step_limits) bound[limit.name] = limit.steps;
  nlohmann::json times = nlohmann::json::array();
  for (const EffectTime& time : summary.effect_times) {
    times.push_back({{"name", time.name}, {"seconds", time.seconds}});
  }
  nlohmann::json json = {{"ending", name_of(summary.ending)},
                         {"reason", summary.reason},
                         {"simulated_time", summary.simulated_time},
                         {"steps", summary.steps},
                         {"rejected_steps", summary.rejected_steps},
                         {"step_limits", bound},
                         {"least_time_step", summary.least_time_step},
                         {"wall_time", summary.wall_time},
                         {"steps_per_second", summary.steps_per_second},
                         {"cells", cells},
                         {"volume_in", summary.volume_in},
                         {"volume_out", summary.volume_out},
                         {"volume_mismatch", summary.volume_mismatch},
                         {"peak_fluid_speed", summary.peak_fluid_speed},
                         {"wrong_side", summary.wrong_side},
                         {"viscosity_iterations", summary.viscosity_iterations},
                         {"pressure_iterations", summary.pressure_iterations},
                         {"effect_times", times}};
  if (summary.poiseuille_deviation >= 0) {
    json["poiseuille_deviation"] = summary.poiseuille_deviation;
    json["poiseuille_deviation_worst"] = summary.poiseuille_deviation_worst;
  }
  return json;
}

}  // namespace rouleau
