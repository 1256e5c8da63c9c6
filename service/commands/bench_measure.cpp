#include "service/commands/bench_measure.h"

#include <chrono>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/simulation/simulation.h"

namespace rouleau::service {

namespace {

// Until memory is there and the solvers start from increments of steps before.
constexpr int warm_up_steps = 5;
constexpr double diameter = 10e-6;

/// Parabolic inflow, so that the flow is what it will be from the first step on.
Case plasma(const std::string& preset, int particles) {
  const nlohmann::json numerics = {{"preset", preset}};
  nlohmann::json scene = {{"version", 1},
                          {"vessel", {{"length", 8 * diameter}, {"diameter", diameter}}},
                          {"inflow", {{"profile", "parabolic"}}},
                          {"numerics", numerics},
                          {"duration", 0.01}};
  const double spacing = read_case(scene).numerics.spacing;
  const double across = diameter / spacing - 1;
  scene["vessel"]["length"] = particles / across * spacing;
  return read_case(scene);
}

}  // namespace

double updates_per_second(const BenchPoint& point, double seconds) {
  return seconds > 0 ? static_cast<double>(point.particles) * point.steps / seconds : 0;
}

BenchPoint bench(const std::string& preset, int particles, int steps) {
  Simulation simulation(plasma(preset, particles));
  for (int k = 0; k < warm_up_steps; ++k) simulation.step();
  const auto before = simulation.costs();
  const auto start = std::chrono::steady_clock::now();
  long updates = 0;
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    updates += simulation.state().particles.active_end();
  }
  BenchPoint point{preset, static_cast<int>(updates / steps), steps, 0, {}};
  point.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto after = simulation.costs();
  double rest = point.seconds;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const double seconds = after[k].usage.seconds - before[k].usage.seconds;
    point.effects.push_back({std::string(after[k].kind->name), seconds});
    rest -= seconds;
  }
  point.effects.push_back({"rest", rest});
  return point;
}

}  // namespace rouleau::service
