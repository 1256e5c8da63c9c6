#include "engine/observe/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/observe/cell_measures.h"
#include "engine/observe/fluid_segments.h"
#include "engine/observe/membrane_measures.h"
#include "engine/observe/poiseuille.h"

namespace rouleau::observe {

namespace {

/// Beside what is wanted there. The published scheme finds its own; else by the fits of the last step.
double worst_divergence(const effects::State& state) {
  std::vector<double> divergence = state.divergence;
  if (state.scene.numerics.preset != Preset::paper) {
    std::vector<double> velocity;
    operators::interleave(state.particles.u, state.particles.v, velocity);
    state.operators.divergences(velocity.data(), divergence);
    for (std::size_t i = 0; i < divergence.size(); ++i) divergence[i] -= state.source[i];
  }
  double worst = 0;
  for (const double d : divergence) worst = std::max(worst, std::abs(d));
  return worst;
}

const std::array cell_columns{Column{"x", "m"},     Column{"y", "m"},         Column{"u", "m/s"},
                              Column{"v", "m/s"},   Column{"tau", "1"},       Column{"tau_area", "1"},
                              Column{"area", "m2"}, Column{"perimeter", "m"}, Column{"angle", "deg"}};

/// They stand behind those of the flow, which keep the places that scripts know.
const std::array membrane_columns{Column{"strain_mean", "1"},
                                  Column{"strain_greatest", "1"},
                                  Column{"tank_treading_phase", "deg"},
                                  Column{"tank_treading_frequency", "1/s"},
                                  Column{"shape", "1"},
                                  Column{"thickness", "m"},
                                  Column{"wall_gap", "m"},
                                  Column{"cell_gap", "m"}};

class Series : public Observer {
 public:
  explicit Series(const effects::State& start) : planes_(flow_planes(start)) {}

  void sample(const effects::State& state, Row& row) override {
    const std::vector<double> values = series_row(state, planes_);
    row.values.insert(row.values.end(), values.begin(), values.end());
  }

 private:
  FlowPlanes planes_;
};

}  // namespace

std::vector<Column> series_columns(const Case& scene) {
  std::vector<Column> columns{{"time", "s"}};
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    const std::string cell = "cell" + std::to_string(k) + ".";
    for (const Column& column : cell_columns) {
      columns.push_back({cell + column.name, column.unit});
    }
  }
  columns.push_back({"inflow", "m2/s"});
  const int outlets = outlet_count(scene.vessel);
  for (int k = 0; k < outlets; ++k) {
    columns.push_back({outlets > 1 ? "outflow" + std::to_string(k) : "outflow", "m2/s"});
  }
  for (const Column& column : {Column{"pressure_drop", "Pa"}, Column{"particles", "1"},
                               Column{"time_step", "s"}, Column{"divergence", "1"}}) {
    columns.push_back(column);
  }
  if (becomes_parabola(scene)) columns.push_back({"poiseuille_deviation", "1"});
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    const std::string cell = "cell" + std::to_string(k) + ".";
    for (const Column& column : membrane_columns) {
      if (column.name == "cell_gap" && scene.cells.size() < 2) continue;
      columns.push_back({cell + column.name, column.unit});
    }
  }
  if (!scene.cells.empty()) columns.push_back({"spacing", "m"});
  return columns;
}

std::vector<double> series_row(const effects::State& state, const FlowPlanes& planes) {
  const Scales& s = state.scales;
  std::vector<double> row{state.time * s.time()};
  for (const effects::CellState& cell : state.cells) {
    if (cell.departure) {
      row.insert(row.end(), cell_columns.size(), std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const CellMeasures m = measure_cell(state, cell);
    row.insert(row.end(), {m.x, m.y, m.u, m.v, m.tau, m.tau_area, m.area, m.perimeter, m.angle});
  }
  const operators::CrossSection inlet = measure(state.particles, planes.inlet);
  row.push_back(inlet.flux * s.flux());
  for (const auto& outlet : planes.outlets) row.push_back(total_flux(state.particles, outlet) * s.flux());
  row.insert(row.end(),
             {pressure_drop(state, inlet) * s.pressure(), static_cast<double>(state.particles.active_end()),
              state.dt * s.time(), worst_divergence(state) * state.spacing});
  if (becomes_parabola(state.scene)) row.push_back(poiseuille_deviation(state));
  for (std::size_t k = 0; k < state.cells.size(); ++k) {
    if (state.cells[k].departure) {
      const std::size_t columns = membrane_columns.size() - (state.cells.size() > 1 ? 0 : 1);
      row.insert(row.end(), columns, std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const MembraneMeasures m = measure_membrane(state, k);
    row.insert(row.end(), {m.mean_strain, m.greatest_strain, m.tank_treading_phase, m.tank_treading_frequency,
                           static_cast<double>(m.shape), m.thickness, m.wall_gap});
    if (state.cells.size() > 1) row.push_back(m.cell_gap);
  }
  if (!state.scene.cells.empty()) row.push_back(state.spacing * s.length);
  return row;
}

const ObserverKind series{"series",
                          false,
                          [](const Case& scene) {
                            const bool asked = scene.output.series_interval > 0;
                            return effects::Need{
                                asked, asked ? "a time series is asked for" : "no time series is asked for",
                                "/output/series_interval"};
                          },
                          [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
                            return std::make_unique<Series>(start);
                          },
                          series_columns,
                          {},
                          {.row = {.once = 2e5, .particle = 40}}};

}  // namespace rouleau::observe
