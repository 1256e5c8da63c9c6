#include "engine/observe/series.h"

#include <algorithm>
#include <cmath>

#include "engine/observe/cell_measures.h"

namespace rouleau::observe {

namespace {

// In spacings: clear of the corners where a plug meets the walls.
constexpr double end_distance = 6;

/// Inlet to outlet: from the first plane on as measured, and before it as developed flow has it.
double pressure_drop(const effects::State& state, double first_plane_pressure) {
  const double height = state.outline.height();
  const double developed_slope = 12 * state.viscosity / (height * height);
  const double outlet = state.scene.outflow.pressure[0] / state.scales.pressure();
  return first_plane_pressure + developed_slope * inflow_plane(state) - outlet;
}

}  // namespace

std::vector<Column> series_columns(const Case& scene) {
  std::vector<Column> columns{{"time", "s"}};
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    const std::string cell = "cell" + std::to_string(k) + ".";
    for (const Column& column :
         {Column{"x", "m"}, Column{"y", "m"}, Column{"u", "m/s"}, Column{"v", "m/s"}, Column{"tau", "1"},
          Column{"tau_area", "1"}, Column{"area", "m2"}, Column{"perimeter", "m"}, Column{"angle", "deg"}}) {
      columns.push_back({cell + column.name, column.unit});
    }
  }
  for (const Column& column :
       {Column{"inflow", "m2/s"}, Column{"outflow", "m2/s"}, Column{"pressure_drop", "Pa"},
        Column{"particles", "1"}, Column{"time_step", "s"}, Column{"divergence", "1"}}) {
    columns.push_back(column);
  }
  return columns;
}

double inflow_plane(const effects::State& state) {
  return end_distance * state.spacing;
}

double outflow_plane(const effects::State& state) {
  return state.outline.length() - end_distance * state.spacing;
}

std::vector<double> series_row(const effects::State& state) {
  const Scales& s = state.scales;
  std::vector<double> row{state.time * s.time()};
  for (const effects::CellState& cell : state.cells) {
    const CellMeasures m = measure_cell(state, cell);
    row.insert(row.end(), {m.x, m.y, m.u, m.v, m.tau, m.tau_area, m.area, m.perimeter, m.angle});
  }
  const auto in = operators::measure(state.particles, state.plane_at(inflow_plane(state)));
  const double out = operators::measure_flux(state.particles, state.plane_at(outflow_plane(state)));
  double divergence = 0;
  for (const double d : state.divergence) divergence = std::max(divergence, std::abs(d));
  row.insert(row.end(), {in.flux * s.flux(), out * s.flux(), pressure_drop(state, in.pressure) * s.pressure(),
                         static_cast<double>(state.particles.active_end()), state.dt * s.time(),
                         divergence * state.spacing});
  return row;
}

}  // namespace rouleau::observe
