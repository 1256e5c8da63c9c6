#include "engine/simulation/run.h"

#include <algorithm>
#include <chrono>

#include "engine/simulation/cell_free_flow.h"
#include "engine/simulation/checkpoint.h"
#include "engine/simulation/lasting.h"
#include "engine/simulation/observers.h"
#include "engine/simulation/run_failure.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/watch_report.h"

namespace rouleau {

namespace {

using Clock = std::chrono::steady_clock;

// s of wall time
constexpr double progress_interval = 0.2;
constexpr double longest_run = 1e9;

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

  template <class Stream>
  friend void visit(Stream& stream, Schedule& schedule) {
    stream(schedule.count_);
    schedule.count_ = std::max(schedule.count_, 0L);
    schedule.next_ = schedule.interval_ * static_cast<double>(schedule.count_);
  }

 private:
  double interval_;
  double next_ = 0;
  long count_ = 0;
};

RunHeader header_of(const Simulation& simulation, const Observers& observers, const Machine& machine) {
  const effects::State& state = simulation.state();
  RunHeader header{observers.recorded(state.scene), {}, {}, {}, 0};
  header.resolved = state.scene;
  header.plan = make_plan(state.scene, machine);
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
    case Ending::failed:
      return "the run went unstable; everything until then is whole";
    case Ending::stopped:
      break;
  }
  return "stopped on request; everything until then is whole";
}

RunSummary summarise(const Simulation& simulation, const Observers& observers, Ending ending, double wall) {
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
  for (const Rejection& rejection : counts.rejections) {
    summary.rejections.push_back({rejection.cause, rejection.steps});
  }
  summary.refinements = simulation.refinements();
  summary.least_time_step = counts.least * state.scales.time();
  for (int k = 0; k < limits; ++k) {
    if (counts.bound[k] > 0) {
      summary.step_limits.push_back({std::string(name_of(static_cast<Limit>(k))), counts.bound[k]});
    }
  }
  summary.peak_fluid_speed = state.counters.peak_speed * state.scales.velocity;
  report_watch(state, summary);
  summary.contact_steps = state.counters.contact_steps;
  summary.wrong_side = state.counters.wrong_side;
  summary.viscosity_iterations = static_cast<double>(state.counters.viscosity_iterations) / steps;
  summary.pressure_iterations = static_cast<double>(state.counters.pressure_iterations) / steps;
  for (const Simulation::Cost& cost : simulation.costs()) {
    const Usage& usage = cost.usage;
    summary.effect_times.push_back({std::string(cost.kind->name), usage.seconds, usage.rounds, usage.awake});
  }
  observers.report(summary);
  return summary;
}

/// A simulation with all that looks at it, from its start or a checkpoint on.
class Run {
 public:
  Run(const Case& resolved, Output& output, const Continuation& continuation, const Machine& machine)
      : simulation_(resolved),
        observers_(simulation_.plan(), simulation_.state(), [&] { return cell_free_flow(resolved); }),
        series_(resolved.output.series_interval),
        frames_(resolved.output.frame_interval),
        checkpoint_interval_(continuation.interval),
        output_(output) {
    const RunHeader header = header_of(simulation_, observers_, machine);
    if (continuation.from) restore(*continuation.from);
    output_.begin(header);
    told_ = saved_ = Clock::now();
  }

  RunSummary to_the_end(const std::stop_token& stop) {
    Ending ending = Ending::completed;
    while (true) {
      look();
      if (simulation_.finished()) break;
      if (simulation_.cell_at_inlet()) {
        ending = Ending::cell_reached_inlet;
        break;
      }
      if (stop.stop_requested()) {
        ending = Ending::stopped;
        if (checkpoint_interval_ > 0) save();
        break;
      }
      if (checkpoint_interval_ > 0 && seconds_since(saved_) >= checkpoint_interval_) save();
      step();
      observers_.follow(state());
      tell();
    }
    return end(ending);
  }

 private:
  const effects::State& state() const { return simulation_.state(); }

  void look() {
    if (series_.due(simulation_.time())) {
      const Row row = observers_.sample(state());
      output_.series_row(row.values);
      if (!row.probes.empty()) output_.probe_row(simulation_.time(), row.probes);
      ++delivered_.rows;
    }
    if (frames_.due(simulation_.time())) {
      output_.frame(observers_.draw(state()));
      ++delivered_.frames;
    }
  }

  void step() {
    try {
      simulation_.step();
    } catch (const SimulationError& error) {
      throw RunFailure(error, end(Ending::failed));
    }
  }

  RunSummary end(Ending ending) {
    output_.progress(progress_of(simulation_, start_));
    return summarise(simulation_, observers_, ending, seconds_since(start_));
  }

  void tell() {
    if (seconds_since(told_) < progress_interval) return;
    output_.progress(progress_of(simulation_, start_));
    told_ = Clock::now();
  }

  void save() {
    delivered_.simulated_time = simulation_.time();
    delivered_.steps = state().step;
    ByteWriter bytes;
    write_head(bytes, delivered_, state().scene);
    double elapsed = seconds_since(start_);
    bytes(elapsed, series_, frames_);
    observers_.save(bytes);
    simulation_.save(bytes);
    output_.checkpoint({bytes.take()});
    saved_ = Clock::now();
  }

  void restore(const Checkpoint& checkpoint) {
    ByteReader bytes(checkpoint.bytes);
    delivered_ = read_head(bytes, state().scene);
    double elapsed = 0;
    bytes(elapsed, series_, frames_);
    observers_.restore(bytes);
    simulation_.restore(bytes);
    if (!bytes.at_end()) throw CheckpointError("the checkpoint is damaged: it is too long");
    if (!(elapsed >= 0 && elapsed < longest_run)) {
      throw CheckpointError("the checkpoint is damaged: it took no such time");
    }
    start_ -= std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(elapsed));
  }

  Clock::time_point start_ = Clock::now();
  Simulation simulation_;
  Observers observers_;
  Schedule series_, frames_;
  CheckpointHead delivered_;
  double checkpoint_interval_;
  Clock::time_point told_, saved_;
  Output& output_;
};

}  // namespace

RunSummary run_case(const Case& resolved, Output& output, const std::stop_token& stop,
                    const Continuation& continuation, const Machine& machine) {
  Run run(resolved, output, continuation, machine);
  return run.to_the_end(stop);
}

}  // namespace rouleau
