#include "engine/simulation/watch_report.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "engine/effects/bounds.h"
#include "engine/effects/watch.h"

namespace rouleau {

namespace {

std::string thinness(int cell, const effects::CellExtremes& extremes, double unit_time, double spacing) {
  std::ostringstream text;
  text << std::setprecision(3) << "cell " << cell << " was squeezed to " << extremes.least_thickness
       << " spacings (twice its area over its perimeter) at t = " << extremes.thinnest_time * unit_time * 1e3
       << " ms; below " << effects::thin << " its particles cannot carry it: a spacing of "
       << extremes.least_thickness * spacing / effects::thin * 1e6 << " um would";
  return text.str();
}

/// The spacing (m) at a time (s); 0 if a finer one was taken there and then, which is the cure.
double spacing_before(double time, double spacing, const std::vector<Refinement>& refinements) {
  constexpr double rounding = 1e-9;
  for (const Refinement& refinement : refinements) {
    if (refinement.time > time * (1 + rounding)) break;
    const bool then = refinement.time > time * (1 - rounding);
    if (then && refinement.spacing < spacing * (1 - rounding)) return 0;
    spacing = refinement.spacing;
  }
  return spacing;
}

std::string drift(int cell, const effects::CellExtremes& extremes) {
  std::ostringstream text;
  text << std::setprecision(3) << "the area of cell " << cell << " was off by up to "
       << 100 * extremes.area_drift << " %: more than " << 100 * effects::area_warning
       << " % says that its membrane leaks or its particles do not carry it";
  return text.str();
}

}  // namespace

void report_watch(const effects::State& state, RunSummary& summary) {
  const Scales& s = state.scales;
  const bool published = state.scene.numerics.preset == Preset::paper;
  summary.watched = {
      {"speed", state.counters.peak_speed * s.velocity, effects::speed_bound(state) * s.velocity, "m/s"}};
  if (published) return;
  summary.watched.push_back({"divergence", state.counters.worst_divergence, effects::divergence_bound, "1"});
  if (state.cells.empty()) return;
  effects::CellExtremes worst;
  for (std::size_t c = 0; c < state.counters.cells.size(); ++c) {
    const effects::CellExtremes& cell = state.counters.cells[c];
    worst.area_drift = std::max(worst.area_drift, cell.area_drift);
    worst.least_perimeter = std::min(worst.least_perimeter, cell.least_perimeter);
    worst.most_perimeter = std::max(worst.most_perimeter, cell.most_perimeter);
    worst.least_thickness = std::min(worst.least_thickness, cell.least_thickness);
    if (cell.area_drift > effects::area_warning) {
      summary.warnings.push_back(drift(static_cast<int>(c), cell));
    }
    const double spacing =
        spacing_before(cell.thinnest_time * s.time(), state.start_spacing * s.length, summary.refinements);
    if (cell.least_thickness < effects::thin && spacing > 0) {
      summary.warnings.push_back(thinness(static_cast<int>(c), cell, s.time(), spacing));
    }
  }
  summary.watched.push_back({"change of area", worst.area_drift, effects::area_bound, "1"});
  summary.watched.push_back({"least perimeter", worst.least_perimeter, effects::least_perimeter, "1"});
  summary.watched.push_back({"greatest perimeter", worst.most_perimeter, effects::most_perimeter, "1"});
  if (state.step > 0)
    summary.watched.push_back({"thickness", worst.least_thickness, effects::thin, "spacings"});
}

}  // namespace rouleau
