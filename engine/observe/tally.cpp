#include "engine/observe/tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/observe/cell_measures.h"
#include "engine/observe/fluid_segments.h"
#include "engine/observe/membrane_measures.h"
#include "engine/observe/poiseuille.h"

namespace rouleau::observe {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

CellDeparture in_si(const effects::Departure& departure, const Scales& scales) {
  return {departure.time * scales.time(), departure.outlet, departure.x * scales.length,
          departure.y * scales.length};
}

}  // namespace

Tally::Tally(const effects::State& state)
    : cells_(state.cells.size(), CellSummary{.peak_tau = 1,
                                             .least_tau = 1,
                                             .greatest_strain = -1,
                                             .least_thickness = infinity,
                                             .least_wall_gap = infinity,
                                             .least_cell_gap = infinity}),
      planes_(flow_planes(state)),
      has_openings_(!state.outline.inlets().empty()),
      develops_(becomes_parabola(state.scene)) {}

void Tally::follow(const effects::State& state) {
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (state.cells[k].departure) {
      cells_[k].departure = in_si(*state.cells[k].departure, state.scales);
      continue;
    }
    const CellMeasures m = measure_cell(state, state.cells[k]);
    const double length = state.scales.length;
    CellSummary& cell = cells_[k];
    if (m.u > cell.peak_velocity) {
      cell.peak_velocity = m.u;
      cell.peak_velocity_x = m.x;
    }
    cell.peak_tau = std::max(cell.peak_tau, m.tau);
    cell.least_tau = std::min(cell.least_tau, m.tau);
    cell.area_deviation =
        std::max(cell.area_deviation, std::abs(m.area / (state.cells[k].start_area * length * length) - 1));
  }
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (!state.cells[k].departure) add_membrane(state, k);
  }
  if (has_openings_) add_flow(state);
  const double half = 0.5 * state.scene.duration / state.scales.time();
  if (develops_ && state.time >= half) {
    const double deviation = poiseuille_deviation(state);
    deviation_sum_ += deviation;
    deviation_worst_ = std::max(deviation_worst_, deviation);
    ++deviation_samples_;
  }
}

void Tally::add_membrane(const effects::State& state, std::size_t k) {
  const MembraneMeasures m = measure_membrane(state, k);
  CellSummary& cell = cells_[k];
  cell.greatest_strain = std::max(cell.greatest_strain, m.greatest_strain);
  cell.least_thickness = std::min(cell.least_thickness, m.thickness);
  cell.least_wall_gap = std::min(cell.least_wall_gap, m.wall_gap);
  cell.least_cell_gap = std::min(cell.least_cell_gap, m.cell_gap);
  cell.time_as[static_cast<std::size_t>(m.shape)] += state.dt;
}

void Tally::add_flow(const effects::State& state) {
  const double area = state.dt * state.scales.length * state.scales.length;
  const double in = area * total_flux(state.particles, planes_.inlet);
  volume_in_ += in;
  volume_through_ += std::abs(in);
  for (const auto& outlet : planes_.outlets) volume_out_ += area * total_flux(state.particles, outlet);
}

void Tally::report(RunSummary& summary) const {
  summary.cells = cells_;
  for (CellSummary& cell : summary.cells) {
    const double all = std::accumulate(cell.time_as.begin(), cell.time_as.end(), 0.0);
    if (all == 0) cell.greatest_strain = cell.least_thickness = 0;
    for (double& share : cell.time_as) share = all > 0 ? share / all : 0;
  }
  summary.volume_in = volume_in_;
  summary.volume_out = volume_out_;
  summary.volume_mismatch = volume_through_ > 0 ? std::abs(volume_out_ - volume_in_) / volume_through_ : 0;
  if (deviation_samples_ > 0) {
    summary.poiseuille_deviation = deviation_sum_ / static_cast<double>(deviation_samples_);
    summary.poiseuille_deviation_worst = deviation_worst_;
  }
}

const ObserverKind run_summary{
    "summary",
    false,
    [](const Case&) {
      return effects::always("the summary says what became of the cells and what was conserved");
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<Tally>(start);
    },
    nullptr,
    {},
    {.step = {.each = 2100, .count = [](const effects::Work& w) { return w.inlet_rows + w.outlet_rows; }}}};

}  // namespace rouleau::observe
