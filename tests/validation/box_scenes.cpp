#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

Case box(const Resolution& resolution, double side, Ends ends) {
  Case scene;
  scene.vessel = {side, side};
  scene.vessel.shape = Shape::box;
  scene.vessel.ends = ends;
  scene.numerics = numerics_at(resolution, side);
  return scene;
}

}  // namespace

// Re = 100 by the box's side and the greatest velocity, for the time in which that would cross the box.
Measurement run_taylor_green(const Resolution& resolution) {
  constexpr double side = 1e-3, velocity = 1e-2;
  Case scene = box(resolution, side, Ends::periodic);
  scene.plasma.kinematic_viscosity = velocity * side / 100;
  scene.initial = {InitialFlow::taylor_green, velocity};
  scene.duration = side / velocity;
  Flow flow(scene);
  flow.finish();
  const effects::State& state = flow.state();
  const auto& p = state.particles;
  const double rate = taylor_green_decay_rate(state.viscosity);
  const double left = std::exp(-rate * state.time);
  double off = 0, most = 0, projection = 0, exact_squares = 0;
  for (int i = 0; i < p.active_end(); ++i) {
    const auto [u, v] = taylor_green(p.x[i], p.y[i]);
    const double du = p.u[i] - left * u, dv = p.v[i] - left * v;
    off += du * du + dv * dv;
    most = std::max(most, std::hypot(du, dv));
    projection += p.u[i] * u + p.v[i] * v;
    exact_squares += u * u + v * v;
  }
  const double measured_rate = -std::log(projection / exact_squares) / state.time;
  Measurement m = flow.measurement();
  m.errors = {{"velocity_rms", std::sqrt(off / exact_squares) / left},
              {"velocity", most / left},
              {"decay_rate", std::abs(measured_rate / rate - 1)}};
  return m;
}

Measurement run_hydrostatic(const Resolution& resolution) {
  constexpr double side = 100e-6, gravity = 9.81;
  Case scene = box(resolution, side, Ends::closed);
  scene.body_acceleration = {0, -gravity};
  scene.duration = side * side / scene.plasma.kinematic_viscosity;
  Flow flow(scene);
  flow.finish();
  const effects::State& state = flow.state();
  const auto& p = state.particles;
  const double g = gravity / state.scales.acceleration();
  const int end = p.active_end();
  double level = 0, off = 0, speed = 0;
  for (int i = 0; i < end; ++i) level += (p.p[i] + g * p.y[i]) / end;
  for (int i = 0; i < end; ++i) {
    off = std::max(off, std::abs(p.p[i] + g * p.y[i] - level));
    speed = std::max(speed, std::hypot(p.u[i], p.v[i]));
  }
  Measurement m = flow.measurement();
  m.errors = {{"pressure", off / g}, {"speed_over_sqrt_gH", speed / std::sqrt(g)}};
  return m;
}

Measurement run_cavity(const Resolution& resolution) {
  constexpr double side = 1e-3, velocity = 0.1;
  Case scene = box(resolution, side, Ends::closed);
  scene.vessel.wall_velocity.upper = velocity;
  scene.plasma.kinematic_viscosity = velocity * side / 100;
  scene.duration = 20 * side / velocity;  // the slowest mode decays as exp(-2 pi^2 t / Re)
  Flow flow(scene);
  flow.finish();
  const auto sampler = flow.sampler();
  const auto& exact = reference("cavity_re100");
  double u_off = 0, v_off = 0;
  for (const auto& [y, u] : exact.at("u_on_the_vertical").get<Table>()) {
    u_off = std::max(u_off, std::abs(sampler.velocity(0.5, y).u - u));
  }
  for (const auto& [x, v] : exact.at("v_on_the_horizontal").get<Table>()) {
    v_off = std::max(v_off, std::abs(sampler.velocity(x, 0.5).v - v));
  }
  Measurement m = flow.measurement();
  m.errors = {{"u_on_the_vertical", u_off}, {"v_on_the_horizontal", v_off}};
  return m;
}

}  // namespace rouleau::validation
