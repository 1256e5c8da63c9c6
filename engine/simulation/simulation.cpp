#include "engine/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/error/simulation_error.h"
#include "engine/simulation/arrange.h"
#include "engine/simulation/lasting.h"
#include "engine/simulation/refinement.h"

namespace rouleau {

namespace {

// Of the flow around particles placed anew: how many steps at most, and the change of velocity that is none.
constexpr int most_settling_steps = 40;
constexpr double settled = 1e-3;
// Of those particles: how many times they shift at most, and what shift is none, in spacings.
constexpr int most_spreading_steps = 30;
constexpr double spread_out = 0.05;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Simulation::Simulation(const Case& resolved, const Rearrangement& rearrange)
    : plan_(make_plan(resolved)),
      state_(resolved, scales_of(resolved), plan_.spacing / scales_of(resolved).length),
      duration_(resolved.duration / state_.scales.time()),
      planned_step_(plan_.time_step / state_.scales.time()),
      step_control_(planned_step_, duration_, resolved.numerics.preset == Preset::paper) {
  place_cells(state_);
  place_fluid(state_);
  place_walls(state_);
  if (rearrange) rearrange(state_);
  make_effects();
  run_stage(effects::Stage::operators);
  const bool flows = initial_flow(resolved) == InitialFlow::developed;
  if (flows && resolved.numerics.preset != Preset::paper) settle();
}

void Simulation::make_effects() {
  for (const effects::EffectKind* kind : effects::catalogue()) {
    if (runs(plan_, kind->name)) effects_.push_back({kind, kind->make(state_), {}});
  }
}

void Simulation::refine(double spacing) {
  refinements_.push_back({time(), state_.thinnest_cell, spacing * state_.scales.length});
  if (spacing == state_.spacing) {
    renew_nodes(state_);
  } else {
    remake(refined(state_, spacing));
  }
  run_stage(effects::Stage::operators);
  settle();
}

void Simulation::remake(effects::State state) {
  state_ = std::move(state);
  const std::vector<Cost> spent = costs();
  effects_.clear();
  make_effects();
  for (std::size_t k = 0; k < spent.size(); ++k) effects_[k].usage = spent[k].usage;
  const double finer = state_.spacing / state_.start_spacing;
  if (!state_.scene.numerics.time_step) step_control_.plan(planned_step_ * finer);
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
    ++running.usage.rounds;
    const auto start = Clock::now();
    if (running.effect->awake(state_)) {
      ++running.usage.awake;
      running.effect->apply(state_);
    }
    running.usage.seconds += seconds_since(start);
  }
}

double Simulation::solve_flow() {
  using effects::Stage;
  start_u_ = state_.particles.u;
  start_v_ = state_.particles.v;
  run_stage(Stage::forces);
  run_stage(Stage::viscosity);
  run_stage(Stage::pressure);
  return note_change_of_velocity();
}

void Simulation::spread() {
  state_.dt = 0;
  double longest = 1;
  for (int k = 0; k < most_spreading_steps && longest > spread_out * state_.spacing; ++k) {
    run_stage(effects::Stage::motion);
    longest = 0;
    for (std::size_t i = 0; i < state_.shift_x.size(); ++i) {
      longest = std::max(longest, std::hypot(state_.shift_x[i], state_.shift_y[i]));
    }
    run_stage(effects::Stage::operators);
  }
}

void Simulation::settle() {
  const effects::Counters counters = state_.counters;
  spread();
  double change = 1;
  for (int k = 0; k < most_settling_steps && change > settled; ++k) {
    before_.take(state_);
    try {
      state_.dt = 0;
      run_stage(effects::Stage::motion);
      run_stage(effects::Stage::boundaries);
      run_stage(effects::Stage::operators);
      state_.dt = planned_step_ * state_.spacing / state_.start_spacing;
      change = solve_flow();
    } catch (const SimulationError&) {
      before_.restore(state_);
      run_stage(effects::Stage::operators);
      change = 0;
    }
  }
  auto& particles = state_.particles;
  std::fill(particles.du.begin(), particles.du.end(), 0.0);
  std::fill(particles.dv.begin(), particles.dv.end(), 0.0);
  state_.counters = counters;
}

double Simulation::attempt() {
  using effects::Stage;
  run_stage(Stage::motion);
  run_stage(Stage::boundaries);
  run_stage(Stage::operators);
  const double change = solve_flow();
  run_stage(Stage::checks);
  return change;
}

double Simulation::note_change_of_velocity() {
  auto& particles = state_.particles;
  const int n = particles.active_end();
  double change2 = 0, speed2 = 0;
  for (int i = 0; i < n; ++i) {
    const double du = particles.u[i] - start_u_[i], dv = particles.v[i] - start_v_[i];
    particles.du[i] = du;
    particles.dv[i] = dv;
    change2 += du * du + dv * dv;
    speed2 += particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
  }
  return std::sqrt(change2 / std::max<double>(speed2, n));
}

void Simulation::step() {
  before_.take(state_);
  while (true) {
    state_.dt = step_control_.choose(state_);
    try {
      const double change = attempt();
      if (step_control_.accurate(state_.dt, change)) {
        step_control_.accept(state_.dt, change);
        break;
      }
      step_control_.reject(state_.dt, "error");
    } catch (const SimulationError& error) {
      if (!error.breach().mendable || !step_control_.reject(state_.dt, error.breach().quantity)) {
        before_.restore(state_);
        throw;
      }
    }
    before_.restore(state_);
    run_stage(effects::Stage::operators);
  }
  state_.last_dt = state_.dt;
  state_.time += state_.dt;
  ++state_.step;
  if (state_.wanted_spacing > 0) refine(state_.wanted_spacing);
}

bool Simulation::cell_at_inlet() const {
  const auto& particles = state_.particles;
  for (const geometry::Opening& inlet : state_.outline.inlets()) {
    for (int i = 0; i < particles.membrane_end(); ++i) {
      if (inlet.beyond(particles.x[i], particles.y[i]) >= -0.5 * state_.spacing) return true;
    }
  }
  return false;
}

std::vector<Simulation::Cost> Simulation::costs() const {
  std::vector<Cost> costs;
  for (const Running& running : effects_) costs.push_back({running.kind, running.usage});
  return costs;
}

void Simulation::save(ByteWriter& bytes) {
  bytes(state_.spacing, refinements_, state_, step_control_);
  for (Running& running : effects_) bytes(running.usage);
}

void Simulation::restore(ByteReader& bytes) {
  double spacing = 0;
  bytes(spacing, refinements_);
  check_spacing(spacing, state_);
  if (spacing != state_.spacing)
    remake(effects::State(state_.scene, state_.scales, spacing, state_.start_spacing));
  const std::size_t lanes = state_.lanes.size();
  bytes(state_, step_control_);
  for (Running& running : effects_) bytes(running.usage);
  check_lasting(state_, lanes);
  run_stage(effects::Stage::operators);
}

}  // namespace rouleau
