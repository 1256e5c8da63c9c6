#include "engine/plan/expected_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/plan/foreseen_stretch.h"

namespace rouleau {

namespace {

// Each coefficient and power is from the runs of docs/plan.md, in which the part that it stands for is the
// largest.

// What the solvers are asked for, over time.
constexpr double unsolved = 1.5e-5;

double square(double x) {
  return x * x;
}

/// The scene in the numbers that errors go by.
struct Measures {
  Measures(const effects::State& start, double spacing_m, double dt)
      : scene(start.scene),
        height(start.outline.height()),
        area(start.outline.area()),
        spacing(spacing_m / start.scales.length),
        gap(start.outline.narrowest()),
        diffusive_time(scene.plasma.kinematic_viscosity / square(start.scales.length)),
        time(scene.duration * diffusive_time),
        step(dt * diffusive_time) {}

  const Case& scene;
  double height, area, spacing, gap;  ///< own units
  double diffusive_time;              ///< nu / H^2, 1/s
  double time, step;                  ///< duration and step in H^2/nu
};

bool is_plug(const Case& scene) {
  return is_open(scene.vessel) && scene.inflow.profile == Profile::plug;
}

/// Where a plug meets the walls the velocity jumps; the flow is off within some spacings of there.
double of_plug(const Measures& m) {
  return is_plug(m.scene) ? 0.19 * std::pow(m.spacing / m.height, 0.7) * m.height / std::sqrt(m.area) : 0;
}

/// Of steady flow past what is in the way; a straight vessel's parabola is exact.
double of_shape(const Measures& m) {
  const Vessel& vessel = m.scene.vessel;
  if (vessel.shape == Shape::bifurcation) return 0.6 * square(m.spacing / m.gap);
  if (!m.scene.thrombi.empty()) return 0.3 * square(m.spacing / m.gap);
  if (vessel.shape == Shape::box) return (vessel.ends == Ends::closed ? 4 : 2) * square(m.spacing / m.height);
  return 0;
}

/// Of a flow that starts from rest or follows a waveform. What the start leaves decays with the slowest mode.
double of_start(const Measures& m) {
  if (!m.scene.inflow.waveform.empty() && is_open(m.scene.vessel)) return 3 * square(m.spacing / m.height);
  if (initial_flow(m.scene) != InitialFlow::rest) return 0;
  constexpr double rate = std::numbers::pi * std::numbers::pi;
  const double left = std::exp(-rate * m.time);
  // The limit on the change of velocity in a step holds the first steps below 0.03 H^2/nu.
  const double in_time = 0.6 * rate * rate * rate * m.time * square(std::min(m.step, 0.03)) * left;
  const double in_space = 0.25 * square(m.spacing / m.height) / m.time * left;
  return std::min(std::hypot(in_time, in_space), 0.3);
}

/// Of each cell over the area that it takes of the vessel.
double of_cells(const Measures& m, double length) {
  double sum = 0;
  for (const RedCell& cell : m.scene.cells) {
    const double diameter = cell.diameter / length;
    const double contrast = cell.viscosity_ratio == 1 ? 1 : 1.5;
    const double local = 0.024 * std::pow(m.spacing / diameter / 0.063, 1.3) * contrast * m.height / m.gap;
    sum += square(local * diameter) / m.area;
  }
  return std::sqrt(sum);
}

/// The published scheme's columns of particles slide past one another in pulses that do not settle.
double of_published_scheme(const Measures& m) {
  const double narrowing = 1 - m.gap / m.height;
  return std::hypot(0.04, 0.7 * narrowing, m.scene.cells.empty() ? 0 : 0.06);
}

double tau_of(const effects::State& start, const Measures& m, const RedCell& cell) {
  // Beyond this the shape changes little: the cell is a thin band.
  constexpr double most_growth = 0.9;
  constexpr double leaking_time = 2.5e-3;  // s
  if (m.scene.numerics.preset == Preset::paper) return 0.1 * (1 - std::exp(-m.scene.duration / leaking_time));
  const double growth = std::min(foresee_stretch(start, cell).at_end, most_growth);
  const double narrowing = 1 - m.gap / m.height;
  const double contrast = std::min(1 + 0.6 * std::abs(cell.viscosity_ratio - 1), 3.0);
  const double of_shape = 0.0035 + 0.03 * square(growth) + 0.03 * narrowing;
  return of_shape * contrast * std::pow(m.spacing * start.scales.length / cell.diameter / 0.063, 1.3);
}

}  // namespace

const char* const expected_error_is =
    "root mean square difference from a run with half of the spacing and step: velocity at the end, over its "
    "own "
    "root mean square; tau over the run, over tau";

ExpectedError expect_error(const effects::State& start, double spacing, double dt, double usual_dt) {
  const Measures m(start, spacing, dt);
  const bool published = m.scene.numerics.preset == Preset::paper;
  // With cells errors in time are of first order.
  const double longer = published ? 1 : std::max(1.0, dt / usual_dt);
  ExpectedError expected;
  expected.velocity = std::hypot(std::hypot(unsolved, of_plug(m), of_shape(m)), of_start(m),
                                 of_cells(m, start.scales.length) * longer);
  if (published) expected.velocity = std::hypot(expected.velocity, of_published_scheme(m));
  double sum = 0;
  for (const RedCell& cell : m.scene.cells) sum += square(tau_of(start, m, cell) * longer);
  if (sum > 0) expected.tau = std::sqrt(sum / static_cast<double>(m.scene.cells.size()));
  return expected;
}

}  // namespace rouleau
