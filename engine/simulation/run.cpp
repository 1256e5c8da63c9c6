#include "engine/simulation/run.h"

#include <algorithm>
#include <chrono>

#include "engine/observe/frames.h"
#include "engine/observe/probes.h"
#include "engine/observe/series.h"
#include "engine/observe/tally.h"
#include "engine/observe/wall_shear.h"
#include "engine/simulation/simulation.h"

namespace rouleau {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double progress_interval = 0.2;  // s of wall time

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Times at which something is due: every `interval` from 0 on, at the first step that reaches it.
class Schedule {
 public:
  explicit Schedule(double interval) : interval_(interval) {}

  bool due(double time) {
    if (interval_ <= 0 || time < next_ - 1e-6 * interval_) return false;
    while (next_ <= time + 1e-6 * interval_) next_ = interval_ * static_cast<double>(++count_);
    return true;
  }

 private:
  double interval_;
  double next_ = 0;
  long count_ = 0;
};

/// Everything that is looked at while a run lasts.
struct Observers {
  explicit Observers(const effects::State& state)
      : planes(observe::flow_planes(state)), probes(state), wall_shear(state), tally(state) {}

  observe::FlowPlanes planes;
  observe::Probes probes;
  observe::WallShear wall_shear;
  observe::Tally tally;
};

RunHeader header_of(const Simulation& simulation, const Observers& observers) {
  const effects::State& state = simulation.state();
  RunHeader header;
  header.resolved = state.scene;
  header.plan = simulation.plan();
  header.columns = observe::series_columns(state.scene);
  header.probes = observers.probes.lines();
  header.walls = observers.wall_shear.nodes();
  for (const effects::CellState& cell : state.cells) header.nodes_per_cell.push_back(cell.nodes);
  header.capacity = state.particles.active_end() * 5 / 4 + 64;
  return header;
}

Progress progress_of(const Simulation& simulation, Clock::time_point start) {
  Progress progress;
  progress.simulated_time = simulation.time();
  progress.duration = simulation.state().scene.duration;
  progress.fraction = std::min(1.0, progress.simulated_time / progress.duration);
  progress.steps = simulation.state().step;
  const double elapsed = seconds_since(start);
  if (elapsed > 0) progress.steps_per_second = static_cast<double>(progress.steps) / elapsed;
  if (progress.fraction > 0) progress.eta_s = elapsed * (1 / progress.fraction - 1);
  return progress;
}

std::string reason_for(Ending ending) {
  switch (ending) {
    case Ending::completed:
      return "the whole duration was simulated";
    case Ending::cell_reached_inlet:
      return "a cell was carried back to the inlet; everything until then is whole";
    case Ending::stopped:
      break;
  }
  return "stopped on request; everything until then is whole";
}

RunSummary summarise(const Simulation& simulation, const observe::Tally& tally, Ending ending, double wall) {
  const effects::State& state = simulation.state();
  RunSummary summary;
  summary.ending = ending;
  summary.reason = reason_for(ending);
  summary.simulated_time = simulation.time();
  summary.steps = state.step;
  summary.wall_time = wall;
  const double steps = static_cast<double>(std::max(1L, state.step));
  if (wall > 0) summary.steps_per_second = static_cast<double>(state.step) / wall;
  const StepCounts& counts = simulation.step_counts();
  summary.rejected_steps = counts.rejected;
  summary.least_time_step = counts.least * state.scales.time();
  for (int k = 0; k < limits; ++k) {
    if (counts.bound[k] > 0) {
      summary.step_limits.push_back({std::string(name_of(static_cast<Limit>(k))), counts.bound[k]});
    }
  }
  tally.report(summary);
  summary.peak_fluid_speed = state.counters.peak_speed * state.scales.velocity;
  summary.wrong_side = state.counters.wrong_side;
  summary.viscosity_iterations = static_cast<double>(state.counters.viscosity_iterations) / steps;
  summary.pressure_iterations = static_cast<double>(state.counters.pressure_iterations) / steps;
  for (const Simulation::Cost& cost : simulation.costs()) {
    summary.effect_times.push_back({std::string(cost.kind->name), cost.seconds});
  }
  return summary;
}

}  // namespace

const char* engine_version() {
  return ROULEAU_VERSION;
}

RunSummary run_case(const Case& resolved, Output& output, const std::stop_token& stop) {
  const auto start = Clock::now();
  Simulation simulation(resolved);
  const effects::State& state = simulation.state();
  Observers observers(state);
  output.begin(header_of(simulation, observers));
  Schedule series(resolved.output.series_interval);
  Schedule frames(resolved.output.frame_interval);
  double observing = 0;
  auto told = start;
  Ending ending = Ending::completed;
  while (true) {
    const auto looked = Clock::now();
    if (series.due(simulation.time())) {
      output.series_row(observe::series_row(state, observers.planes));
      if (!state.scene.probes.empty()) output.probe_row(simulation.time(), observers.probes.sample(state));
    }
    if (frames.due(simulation.time())) output.frame(observe::make_frame(state, observers.wall_shear));
    observing += seconds_since(looked);
    if (simulation.finished()) break;
    if (simulation.cell_at_inlet()) {
      ending = Ending::cell_reached_inlet;
      break;
    }
    if (stop.stop_requested()) {
      ending = Ending::stopped;
      break;
    }
    simulation.step();
    const auto tallied = Clock::now();
    observers.tally.add(state);
    observing += seconds_since(tallied);
    if (seconds_since(told) >= progress_interval) {
      output.progress(progress_of(simulation, start));
      told = Clock::now();
    }
  }
  output.progress(progress_of(simulation, start));
  RunSummary summary = summarise(simulation, observers.tally, ending, seconds_since(start));
  summary.effect_times.push_back({"observers", observing});
  return summary;
}

}  // namespace rouleau
