#include <algorithm>
#include <cmath>
#include <random>

#include "engine/cells/shape.h"
#include "tests/stability/scenes.h"

namespace rouleau::stability {

namespace {

using effects::State;
using particles::Group;

/// With the planned step times `factor`, against the planned one: within 5 % of the way, or refused.
Report run_time_step(Form form, double factor) {
  Case scene = past_thrombus(form);
  const SceneRun normal(scene);
  scene.numerics.time_step = factor * make_plan(scene).time_step;
  SceneRun coarse(scene);
  if (coarse.report.outcome == "completed") {
    coarse.report.worst["trajectory"] = {.value = deviation(normal.path, coarse.path, 0), .bound = 0.05};
  }
  return coarse.report;
}

/// Whether a particle may be put there: at least a twentieth of a spacing from walls and membranes, and in
/// the cell that it belongs to or in none.
bool may_be_at(const State& state, int particle, double x, double y) {
  const double least = 0.05 * state.spacing;
  if (!state.outline.contains(x, y) || state.outline.distance(x, y).value < least) return false;
  for (std::size_t c = 0; c < state.cells.size(); ++c) {
    const cells::Ring ring = state.ring(state.cells[c]);
    const bool belongs = state.particles.cell[particle] == static_cast<int>(c);
    if (cells::nearest(ring, x, y).distance < least || cells::contains(ring, x, y) != belongs) return false;
  }
  return true;
}

/// Every fluid particle by up to 0.45 d0 along x and y, the same at every run.
void disorder(State& state) {
  std::mt19937 random;
  const auto uniform = [&] { return (static_cast<double>(random()) / std::mt19937::max() - 0.5) * 0.9; };
  auto& p = state.particles;
  for (int i = 0; i < p.size(); ++i) {
    if (p.group[i] != Group::fluid) continue;
    const double x = p.x[i] + uniform() * state.spacing, y = p.y[i] + uniform() * state.spacing;
    if (!may_be_at(state, i, x, y)) continue;
    p.x[i] = x;
    p.y[i] = y;
  }
}

/// What lies within 4 d0 of a place ahead of the cell is drawn to half its distance from it.
void clump(State& state) {
  constexpr double radius = 4, contraction = 0.5;
  auto& p = state.particles;
  const double x0 = p.x[state.cells[0].first_node] + 10 * state.spacing, y0 = 0.5 * state.outline.height();
  for (int i = 0; i < p.size(); ++i) {
    const double dx = p.x[i] - x0, dy = p.y[i] - y0;
    if (p.group[i] != Group::fluid || std::hypot(dx, dy) > radius * state.spacing) continue;
    p.x[i] = x0 + contraction * dx;
    p.y[i] = y0 + contraction * dy;
  }
}

/// Every twentieth fluid particle is there twice.
void duplicate(State& state) {
  auto& p = state.particles;
  const int placed = p.size();
  for (int i = 0; i < placed; ++i) {
    if (p.group[i] != Group::fluid || i % 20 != 0) continue;
    const int twin = p.add(Group::fluid, p.x[i], p.y[i], p.cell[i]);
    p.u[twin] = p.u[i];
    p.v[twin] = p.v[i];
    p.p[twin] = p.p[i];
  }
}

Report run_rearranged(Form form, const Simulation::Rearrangement& rearrange) {
  return watched(past_thrombus(form), rearrange);
}

Report run_spacing(Form form, double spacing) {
  Case scene = past_thrombus(form);
  if (form == Form::brief && spacing < scene.numerics.spacing) {
    scene.cells[0].x += 4e-6;
    scene.duration = 1e-3;
  }
  scene.numerics.spacing = spacing;
  return watched(scene);
}

Case closed_box(double side) {
  Case scene;
  scene.vessel = {side, side, Shape::box, Ends::closed};
  scene.output = {0, 0, {}};
  return scene;
}

/// Turned around by a lid.
Report run_box_with_cell(Form form) {
  constexpr double side = 20e-6;
  Case scene = closed_box(side);
  scene.vessel.wall_velocity.upper = 0.005;
  scene.cells.push_back(cell_at(side / 2, side / 2));
  scene.duration = form == Form::full ? 30e-3 : 4e-3;
  return watched(scene);
}

/// Plasma under its weight: its kinetic energy, over what it would take to lift it by the tank's height,
/// never rises.
Report run_resting_tank(Form form) {
  constexpr double side = 10e-6, gravity = 9.81;
  Case scene = closed_box(side);
  scene.body_acceleration = {0, -gravity};
  scene.duration = 1;
  scene.duration = make_plan(scene).time_step * (form == Form::full ? 1e5 : 2e3);
  SceneRun run(scene);
  double least = run.kinetic_energy.front(), rise = 0;
  for (const double energy : run.kinetic_energy) {
    rise = std::max(rise, energy - least);
    least = std::min(least, energy);
  }
  run.report.worst["energy_rise"] = {.value = rise / run.potential_energy, .bound = 1e-12};
  return run.report;
}

/// 25 ms and more; the study ends at 22.5.
Report run_long_time(Form form, bool with_cell) {
  const bool full = form == Form::full;
  Case scene = past_thrombus(form);
  scene.duration = full ? 25e-3 : 6e-3;
  if (with_cell) {
    scene.vessel.length = full ? 200e-6 : 65e-6;
  } else {
    scene.cells.clear();
  }
  return watched(scene);
}

}  // namespace

std::vector<Scene> numerical_scenes() {
  const auto with = [](auto run, auto value) { return [=](Form form) { return run(form, value); }; };
  return {
      {"time_step_x10", "time step times 10, past the 8 d0 thrombus", with(run_time_step, 10.0)},
      {"time_step_x100", "time step times 100", with(run_time_step, 100.0)},
      {"disordered", "disordered starting particles", with(run_rearranged, disorder)},
      {"clumped", "clumped starting particles, beside a hole", with(run_rearranged, clump)},
      {"duplicates", "every twentieth starting particle twice at one place", with(run_rearranged, duplicate)},
      {"spacing_x2", "d0 twice as coarse, past the 8 d0 thrombus", with(run_spacing, 8e-7)},
      {"spacing_half", "d0 half as fine", with(run_spacing, 2e-7)},
      {"box_cell", "a closed box with a cell, turned around by a lid", run_box_with_cell},
      {"resting_tank", "a resting tank for 1e5 steps, its energy never rising", run_resting_tank},
      {"long_time", "25 ms of plasma past the 8 d0 thrombus", with(run_long_time, false)},
      {"long_time_cell", "25 ms of a cell in a vessel of 200 um", with(run_long_time, true)}};
}

}  // namespace rouleau::stability
