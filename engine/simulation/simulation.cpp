#include "engine/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/simulation/arrange.h"

namespace rouleau {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The explicit transport of pressure is unstable from |u| dt / d0 = 0.7 on.
constexpr double largest_courant = 0.5;

}  // namespace

Simulation::Simulation(const Case& resolved)
    : plan_(make_plan(resolved)),
      state_(resolved, scales_of(resolved), plan_.spacing / scales_of(resolved).length),
      duration_(resolved.duration / state_.scales.time()),
      planned_step_(plan_.time_step / state_.scales.time()) {
  place_cells(state_);
  place_fluid(state_);
  place_walls(state_);
  for (const effects::EffectKind* kind : effects::catalogue()) {
    const auto planned = std::find_if(plan_.effects.begin(), plan_.effects.end(),
                                      [&](const PlannedEffect& e) { return e.name == kind->name; });
    if (planned->on) effects_.push_back({kind, kind->make(state_)});
  }
  sort_particles(state_.particles, state_.spacing);
}

double Simulation::time() const {
  return state_.time * state_.scales.time();
}

bool Simulation::finished() const {
  return duration_ - state_.time < 1e-6 * planned_step_;
}

void Simulation::run_stage(effects::Stage stage) {
  for (Running& running : effects_) {
    if (running.kind->stage != stage) continue;
    const auto start = Clock::now();
    running.effect->apply(state_);
    running.seconds += seconds_since(start);
  }
}

void Simulation::build_operators() {
  const auto start = Clock::now();
  auto& s = state_;
  sort_particles(s.particles, s.spacing);
  s.neighbours.build(s.particles);
  if (s.scene.numerics.preset != Preset::paper) s.operators.build(s.particles, s.neighbours);
  const auto active = static_cast<std::size_t>(s.particles.active_end());
  for (auto* field :
       {&s.ax, &s.ay, &s.source, &s.divergence, &s.pressure_gx, &s.pressure_gy, &s.shift_x, &s.shift_y}) {
    field->assign(active, 0);
  }
  const auto nodes = static_cast<std::size_t>(s.particles.membrane_end());
  s.load.fx.assign(nodes, 0);
  s.load.fy.assign(nodes, 0);
  s.load.stiffness.clear();
  s.implicit_forces.clear();
  operator_seconds_ += seconds_since(start);
}

void Simulation::step() {
  using effects::Stage;
  state_.dt = std::min({planned_step_, largest_courant * state_.spacing / std::max(state_.speed, 1e-30),
                        duration_ - state_.time});
  run_stage(Stage::boundaries);
  build_operators();
  run_stage(Stage::forces);
  run_stage(Stage::viscosity);
  run_stage(Stage::pressure);
  run_stage(Stage::motion);
  run_stage(Stage::checks);
  state_.time += state_.dt;
  ++state_.step;
}

bool Simulation::cell_at_outlet() const {
  const auto& x = state_.particles.x;
  const double limit = state_.outline.length() - 0.5 * state_.spacing;
  return std::any_of(x.begin(), x.begin() + state_.particles.membrane_end(),
                     [&](double node) { return node >= limit; });
}

std::vector<Simulation::Cost> Simulation::costs() const {
  std::vector<Cost> costs;
  for (const Running& running : effects_) costs.push_back({running.kind, running.seconds});
  return costs;
}

}  // namespace rouleau
