#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/observe/cell_measures.h"
#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

constexpr double height = 10e-6;
constexpr double velocity = 0.005;

observe::CellMeasures measured(const Flow& flow) {
  return observe::measure_cell(flow.state(), flow.state().cells.front());
}

/// Mean velocity over U, and tau, while the centroid is within a micrometre of `x`.
std::array<double, 2> mean_around(Flow& flow, double x) {
  constexpr double half_width = 1e-6;
  double time = 0, distance = 0, tau = 0;
  observe::CellMeasures last = measured(flow);
  while (!flow.finished() && last.x < x + half_width) {
    const double start = flow.time();
    flow.step();
    const observe::CellMeasures now = measured(flow);
    if (last.x > x - half_width) {
      time += flow.time() - start;
      distance += now.x - last.x;
      tau += (flow.time() - start) * now.tau_area;
    }
    last = now;
  }
  return {distance / time / velocity, tau / time};
}

}  // namespace

// The study's vessel and cell, ten times as stiff in stretch, upright on the axis.
Measurement run_cell_in_channel(const Resolution& resolution) {
  const nlohmann::json& exact = reference("cell_in_channel");
  Case scene;
  scene.vessel = {8 * height, height};
  scene.inflow.velocity = velocity;
  RedCell cell;
  cell.x = 16e-6;
  cell.y = height / 2;
  cell.stretch_modulus = 1e-4;
  scene.cells = {cell};
  scene.numerics = numerics_at(resolution, height);
  scene.duration = 7.5e-3;
  Flow flow(scene);
  Measurement m;
  double tau = 0, off = 0;
  for (const auto& [x, v] : exact.at("velocity").get<Table>()) {
    const auto [found, tau_here] = mean_around(flow, x * 1e-6);
    off = std::max(off, std::abs(found / v - 1));
    m.values.emplace_back("velocity_at_" + std::to_string(std::lround(x)) + "um", found);
    tau = tau_here;
  }
  m.values.emplace_back("tau_at_59um", tau);
  const Measurement run = flow.measurement();
  m.simulated_time = run.simulated_time;
  m.steps = run.steps;
  m.particles = run.particles;
  m.errors = {{"velocity", off}, {"tau_at_59um", std::abs(tau / exact.at("tau_at_59um").get<double>() - 1)}};
  return m;
}

// The study's cell past the thrombus of 8 spacings, its membrane inextensible.
Measurement run_held_past_thrombus(const Resolution& resolution) {
  Case scene;
  scene.vessel = {8 * height, height};
  scene.inflow.velocity = velocity;
  scene.thrombi = {{Wall::lower, 32e-6, 3.2e-6}};
  RedCell cell;
  cell.x = 16e-6;
  cell.y = height / 2;
  scene.cells = {cell};
  scene.effects["inextensible"] = Switch::on;
  scene.numerics = numerics_at(resolution, height);
  scene.duration = 7e-3;
  Flow flow(scene);
  double length = 0, perimeter = 0;
  while (!flow.finished()) {
    flow.step();
    const effects::CellState& now = flow.state().cells.front();
    const cells::Ring ring = flow.state().ring(now);
    length = std::max(length, cells::greatest_length_error(ring, now.held));
    perimeter = std::max(perimeter, std::abs(cells::perimeter(ring) / now.start_perimeter - 1));
  }
  Measurement m = flow.measurement();
  m.errors = {{"length", length}, {"perimeter", perimeter}};
  return m;
}

// The study's cell in plasma that nothing moves. The first tenth of a millisecond, in which the membrane and
// what was placed around it find their balance, does not count.
Measurement run_resting_cell(const Resolution& resolution) {
  constexpr double settled = 1e-4, duration = 3e-3;
  Case scene;
  scene.vessel = {2 * height, height};
  scene.vessel.ends = Ends::periodic;
  RedCell cell;
  cell.x = height;
  cell.y = height / 2;
  scene.cells = {cell};
  scene.numerics = numerics_at(resolution, height);
  scene.duration = duration;
  Flow flow(scene);
  flow.advance_to(settled);
  const observe::CellMeasures start = measured(flow);
  double fastest = 0, drift = 0;
  const double since = flow.time();
  while (!flow.finished()) {
    flow.step();
    fastest = std::max(fastest, flow.state().speed * flow.state().scales.velocity);
    const observe::CellMeasures now = measured(flow);
    drift = std::max(drift, std::hypot(now.x - start.x, now.y - start.y));
  }
  Measurement m = flow.measurement();
  m.errors = {{"drift_a_ms", drift / (cell.diameter / 2) / ((flow.time() - since) / 1e-3)},
              {"speed", fastest / velocity}};
  return m;
}

}  // namespace rouleau::validation
