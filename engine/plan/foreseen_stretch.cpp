#include "engine/plan/foreseen_stretch.h"

#include <algorithm>
#include <cmath>

#include "engine/case/waveform.h"
#include "engine/effects/thin_cells.h"

namespace rouleau {

namespace {

// Growth of the perimeter e in time t, from runs: e = most (1 - exp(-pace (rate t - delay) / most)) with most
// = compliance Ca.
constexpr double compliance = 2.8;
constexpr double pace = 0.55;
constexpr double delay = 0.3;
// Past a thrombus a cell stretches farther, by this power of what the vessel is wider than the gap.
constexpr double squeeze = 0.6;
// The perimeter of a biconcave cell over that of the circle from which it is deflated.
constexpr double relaxed_perimeter = 0.9;
using effects::most_refinement;
using effects::restored;
using effects::seen_coming;

double shear_rate(const effects::State& start, const RedCell& cell) {
  const Case& scene = start.scene;
  const double height = scene.vessel.diameter;
  if (scene.vessel.shape == Shape::box || scene.vessel.ends == Ends::closed)
    return start.scales.velocity / height;
  const WallVelocity& walls = scene.vessel.wall_velocity;
  const double between_walls = std::abs(walls.upper - walls.lower) / height;
  const double mean = start.scales.velocity * (is_open(scene.vessel) ? largest_factor(scene.inflow) : 1);
  // Of the parabola, from its middle to the end of a cell that lies across.
  const double of_parabola = 3 * mean * cell.diameter / (height * height);
  return between_walls > 0 ? between_walls : of_parabola;
}

/// When the perimeter has grown by that much, s.
double time_of(const ForeseenStretch& stretch, double growth) {
  if (growth >= stretch.most) return 1e300;
  return (delay - stretch.most / pace * std::log(1 - growth / stretch.most)) / stretch.rate;
}

double growth_at(const ForeseenStretch& stretch, double time) {
  const double strained = std::max(0.0, stretch.rate * time - delay);
  return stretch.most > 0 ? stretch.most * (1 - std::exp(-pace * strained / stretch.most)) : 0;
}

}  // namespace

ForeseenStretch foresee_stretch(const effects::State& start, const RedCell& cell) {
  const Case& scene = start.scene;
  const double viscosity = scene.plasma.density * scene.plasma.kinematic_viscosity;
  ForeseenStretch stretch;
  stretch.rate = shear_rate(start, cell);
  stretch.capillary = viscosity * stretch.rate * cell.diameter / 2 / cell.stretch_modulus;
  stretch.most = compliance * stretch.capillary * 2 / (1 + cell.viscosity_ratio) *
                 std::pow(start.outline.height() / start.outline.narrowest(), squeeze);
  stretch.at_end = growth_at(stretch, scene.duration);
  return stretch;
}

std::vector<SpacingSpan> foresee_spacings(const effects::State& start, double spacing) {
  const Case& scene = start.scene;
  std::vector<SpacingSpan> spans;
  double time = 0, now = spacing;
  const bool refines = scene.numerics.refine == Refine::automatic && scene.numerics.preset != Preset::paper;
  while (refines) {
    double next = 1e300, finer = now;
    for (const RedCell& cell : scene.cells) {
      const ForeseenStretch stretch = foresee_stretch(start, cell);
      const double at_rest = cell.fill * cell.diameter / (2 * relaxed_perimeter);
      const double thin = time_of(stretch, std::max(0.0, at_rest / (seen_coming * now) - 1));
      if (thin >= next) continue;
      next = thin;
      finer = std::max(now * seen_coming / restored, spacing / most_refinement);
    }
    if (next >= scene.duration || finer >= 0.99 * now) break;
    next = std::max(next, time);
    spans.push_back({next - time, now});
    time = next;
    now = finer;
  }
  spans.push_back({scene.duration - time, now});
  return spans;
}

}  // namespace rouleau
