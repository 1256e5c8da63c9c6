#include "tests/stability/scene_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/error/simulation_error.h"

namespace rouleau::stability {

namespace {

// A run whose step has shrunk so far that it takes this many steps for each one that the scene would have at
// a step of its own choice does not end.
constexpr long most_steps = 20;

long steps_of_own_choice(Case scene) {
  scene.numerics.time_step.reset();
  return make_plan(scene).steps;
}

Centroid at(const std::vector<double>& times, const std::vector<Centroid>& places, double time) {
  const auto after = std::lower_bound(times.begin(), times.begin() + std::ptrdiff_t(places.size()), time);
  const auto k = static_cast<std::size_t>(after - times.begin());
  if (k == 0) return places.front();
  if (k == places.size()) return places.back();
  const double s = (time - times[k - 1]) / (times[k] - times[k - 1]);
  return {std::lerp(places[k - 1].x, places[k].x, s), std::lerp(places[k - 1].y, places[k].y, s)};
}

double distance(const Centroid& one, const Centroid& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

}  // namespace

std::vector<std::string> Report::misses() const {
  std::vector<std::string> missed;
  if (outcome != "completed") missed.emplace_back("outcome");
  for (const auto& [name, worst_of_it] : worst) {
    if (!(worst_of_it.value <= worst_of_it.bound)) missed.push_back(name);
  }
  return missed;
}

SceneRun::SceneRun(const Case& scene, const Simulation::Rearrangement& rearrange) {
  Watcher watcher;
  try {
    Simulation simulation(read_case(to_json(scene), check_effects), rearrange);
    finish(simulation, watcher);
  } catch (const CaseError& refusal) {
    report.outcome = "refused";
    report.message = refusal.what();
  }
  report.worst = watcher.worst();
}

void SceneRun::note(const Simulation& simulation) {
  const effects::State& state = simulation.state();
  path.times.push_back(simulation.time());
  path.centroids.resize(state.cells.size());
  for (std::size_t c = 0; c < state.cells.size(); ++c) {
    if (state.cells[c].nodes > 0) path.centroids[c].push_back(centroid_of(state, c));
  }
  const auto& p = state.particles;
  double energy = 0;
  for (int i = 0; i < p.active_end(); ++i) energy += 0.5 * (p.u[i] * p.u[i] + p.v[i] * p.v[i]);
  kinetic_energy.push_back(energy / p.active_end());
}

void SceneRun::finish(Simulation& simulation, Watcher& watcher) {
  const effects::State& state = simulation.state();
  const auto& acceleration = state.scene.body_acceleration;
  potential_energy =
      std::hypot(acceleration[0], acceleration[1]) / state.scales.acceleration() * state.outline.height();
  report.outcome = "completed";
  note(simulation);
  const long end = most_steps * steps_of_own_choice(state.scene);
  try {
    while (!simulation.finished()) {
      if (state.step >= end) {
        report.outcome = "stopped";
        report.message =
            "after " + std::to_string(end) + " steps, at t = " + std::to_string(simulation.time() * 1e3) +
            " ms, the time step is " + std::to_string(state.last_dt * state.scales.time() * 1e6) + " us";
        break;
      }
      simulation.step();
      watcher.look(state);
      note(simulation);
    }
  } catch (const SimulationError& failure) {
    report.outcome = "stopped";
    report.message = failure.what();
  }
  report.simulated_time = simulation.time();
  report.steps = state.step;
  report.rejected = simulation.step_counts().rejected;
  report.put_back = state.counters.wrong_side;
  report.particles = state.particles.active_end();
}

double deviation(const Path& one, const Path& other, std::size_t cell) {
  const auto& places = one.centroids.at(cell);
  double way = 0, most = 0;
  for (std::size_t k = 1; k < places.size(); ++k) way += distance(places[k - 1], places[k]);
  for (std::size_t k = 0; k < other.centroids.at(cell).size(); ++k) {
    most = std::max(most, distance(other.centroids[cell][k], at(one.times, places, other.times[k])));
  }
  return most / way;
}

}  // namespace rouleau::stability
