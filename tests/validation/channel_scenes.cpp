#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/run.h"
#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

using std::numbers::pi;

constexpr double height = 10e-6;
constexpr double velocity = 0.005;
constexpr double viscosity = 1e-6;
constexpr double viscous_time = height * height / viscosity;

/// Between walls, two heights long and periodic, from rest.
Case periodic_channel(const Resolution& resolution) {
  Case scene;
  scene.vessel = {2 * height, height};
  scene.vessel.ends = Ends::periodic;
  scene.numerics = numerics_at(resolution, height);
  // The step goes with the spacing, so that a finer run is finer in time as well.
  if (!scene.numerics.time_step) scene.numerics.time_step = 0.25 / resolution.across * viscous_time;
  scene.duration = 0.5 * viscous_time;
  return scene;
}

/// The greatest error of u over all particles at four times of the start, over the greatest velocity.
template <class Exact>
Measurement run_start(const Case& scene, double greatest, const Exact& exact) {
  Flow flow(scene);
  std::vector<std::pair<std::string, double>> errors;
  for (const auto& [time, name] : {std::pair{0.05, "velocity_at_0.05"}, std::pair{0.1, "velocity_at_0.1"},
                                   std::pair{0.2, "velocity_at_0.2"}, std::pair{0.5, "velocity_at_0.5"}}) {
    flow.advance_to(time * viscous_time);
    const auto& particles = flow.state().particles;
    const double unit = greatest / flow.state().scales.velocity;
    double most = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
      const double wanted = exact(particles.y[i], flow.time() / viscous_time);
      most = std::max(most, std::abs(particles.u[i] / unit - wanted));
    }
    errors.emplace_back(name, most);
  }
  Measurement m = flow.measurement();
  m.errors = errors;
  return m;
}

Case open_channel(const Resolution& resolution, double length) {
  Case scene;
  scene.vessel = {length, height};
  scene.inflow = {velocity, Profile::parabolic, {}};
  scene.numerics = numerics_at(resolution, height);
  return scene;
}

/// The flow out of the vessel, as the series has it.
class Outflow : public Output {
 public:
  void begin(const RunHeader& header) override {
    const auto is_outflow = [](const Column& column) { return column.name == "outflow"; };
    column_ = static_cast<std::size_t>(
        std::find_if(header.columns.begin(), header.columns.end(), is_outflow) - header.columns.begin());
  }
  void series_row(std::span<const double> row) override { values_.push_back(row[column_]); }

  /// Half the range over its second half, over its mean there.
  double ripple() const {
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2);
    const auto [least, most] = std::minmax_element(begin, values_.end());
    return (*most - *least) / (*most + *least);
  }

 private:
  std::size_t column_ = 0;
  std::vector<double> values_;
};

/// Velocity on points across the vessel, over the mean inflow velocity.
std::vector<double> profile(const Flow& flow, double x) {
  constexpr int points = 40;
  const auto sampler = flow.sampler();
  std::vector<double> u;
  for (int k = 1; k < points; ++k) u.push_back(sampler.velocity(x, static_cast<double>(k) / points).u);
  return u;
}

/// Waveform of a sine, by straight pieces short enough to be taken for it.
std::vector<WaveformPoint> sine(double period, int cycles) {
  constexpr int pieces = 100;
  std::vector<WaveformPoint> points;
  for (int k = 0; k <= pieces * cycles; ++k) {
    points.push_back({period * k / pieces, std::sin(2 * pi * k / pieces)});
  }
  return points;
}

}  // namespace

Measurement run_couette_start(const Resolution& resolution) {
  Case scene = periodic_channel(resolution);
  scene.vessel.wall_velocity.upper = velocity;
  return run_start(scene, velocity, couette_start);
}

Measurement run_poiseuille_start(const Resolution& resolution) {
  Case scene = periodic_channel(resolution);
  const double greatest = 1.5 * velocity;
  scene.body_acceleration = {8 * viscosity * greatest / (height * height), 0};
  return run_start(scene, greatest, poiseuille_start);
}

Measurement run_poiseuille(const Resolution& resolution, Profile inflow) {
  Case scene = open_channel(resolution, 8 * height);
  scene.inflow.profile = inflow;
  scene.duration = 1e-3;
  scene.output = {1e-5, 0, {}};
  Outflow outflow;
  const RunSummary summary = run_case(scene, outflow);
  Measurement m;
  m.simulated_time = summary.simulated_time;
  m.steps = summary.steps;
  m.errors = {{"profile_mean", summary.poiseuille_deviation},
              {"profile_worst", summary.poiseuille_deviation_worst},
              {"flux_ripple", outflow.ripple()}};
  return m;
}

Measurement run_long_channel(const Resolution& resolution) {
  Case scene = open_channel(resolution, 40 * height);
  scene.duration = 1e-3;
  Flow flow(scene);
  flow.finish();
  const std::vector<double> middle = profile(flow, 20), end = profile(flow, 39);
  double between = 0, from_exact = 0;
  for (std::size_t k = 0; k < end.size(); ++k) {
    const double y = static_cast<double>(k + 1) / static_cast<double>(end.size() + 1);
    between = std::max(between, std::abs(end[k] - middle[k]));
    from_exact = std::max(from_exact, std::abs(end[k] - poiseuille(y)));
  }
  Measurement m = flow.measurement();
  m.errors = {{"end_against_middle", between}, {"profile_at_end", from_exact}};
  return m;
}

Measurement run_womersley(const Resolution& resolution) {
  // Womersley number 2.5. The plasma moves to and fro by a third of the height.
  constexpr double width = 20e-6, period = 1e-4, amplitude = 0.2;
  constexpr int cycles = 5, samples = 16;
  const double number = width / 2 * std::sqrt(2 * pi / period / viscosity);
  Case scene;
  scene.vessel = {3 * width, width};
  scene.inflow = {amplitude, Profile::parabolic, sine(period, cycles)};
  scene.initial.flow = InitialFlow::rest;
  scene.numerics = numerics_at(resolution, width);
  scene.duration = cycles * period;
  Flow flow(scene);
  const int at_start = flow.state().particles.active_end();
  int after_first = at_start;
  double most = 0, squares = 0;
  long values = 0;
  for (int k = 1; k <= cycles * samples; ++k) {
    flow.advance_to(period * k / samples);
    if (k == samples) after_first = flow.state().particles.active_end();
    if (k <= samples) continue;  // the start from rest dies away
    const std::vector<double> u = profile(flow, 1.5);
    for (std::size_t j = 0; j < u.size(); ++j) {
      const double y = static_cast<double>(j + 1) / static_cast<double>(u.size() + 1);
      const double off = u[j] - womersley(y, 2 * pi * flow.time() / period, number);
      most = std::max(most, std::abs(off));
      squares += off * off;
      ++values;
    }
  }
  Measurement m = flow.measurement();
  const double drift = std::abs(m.particles - after_first) / (cycles - 1.0);
  m.errors = {{"velocity", most},
              {"velocity_rms", std::sqrt(squares / static_cast<double>(values))},
              {"particles_a_cycle", drift / at_start}};
  return m;
}

}  // namespace rouleau::validation
