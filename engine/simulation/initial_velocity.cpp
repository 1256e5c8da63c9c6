#include "engine/simulation/initial_velocity.h"

#include <cmath>
#include <numbers>

#include "engine/case/waveform.h"

namespace rouleau {

namespace {

InitialFlow flow_of(const Case& scene) {
  if (scene.initial.flow != InitialFlow::automatic) return scene.initial.flow;
  return is_open(scene.vessel) ? InitialFlow::developed : InitialFlow::rest;
}

/// Mean axial velocity of the developed flow.
double mean_velocity(const effects::State& state) {
  if (is_open(state.scene.vessel)) return waveform_factor(state.scene.inflow, 0);
  const double height = state.outline.height();
  const double driven = state.scene.body_acceleration[0] / state.scales.acceleration();
  return driven * height * height / (12 * state.viscosity);
}

}  // namespace

InitialVelocity::InitialVelocity(const effects::State& state)
    : outline_(state.outline), flow_(flow_of(state.scene)), mean_(mean_velocity(state)) {
  if (state.scene.vessel.ends == Ends::closed) {
    for (std::size_t d = 0; d < 2; ++d) {
      weight_[d] = state.scene.body_acceleration[d] / state.scales.acceleration();
    }
  }
  if (state.scene.vessel.shape != Shape::bifurcation) return;
  // Each branch's share is by its conductance, width^3 / length.
  double conductance = 0;
  const auto& branches = state.scene.vessel.branches;
  for (const Branch& b : branches) conductance += std::pow(b.diameter, 3) / b.length;
  for (std::size_t k = 0; k < 2; ++k) {
    const double share = std::pow(branches[k].diameter, 3) / branches[k].length / conductance;
    branch_mean_[k] = mean_ * share * outline_.height() / outline_.outlets()[k].width;
  }
}

std::array<double, 2> InitialVelocity::developed(double x, double y) const {
  if (x > outline_.length()) {
    for (std::size_t k = 0; k < 2; ++k) {
      const geometry::Opening& outlet = outline_.outlets()[k];
      const double fraction = outlet.across(x, y) / outlet.width;
      const bool this_half = (k == 0) == (y < outline_.height() / 2);
      if (!this_half || fraction < 0 || fraction > 1) continue;
      const double velocity = branch_mean_[k] * effects::State::parabola(fraction);
      return {velocity * outlet.ax, velocity * outlet.ay};
    }
    return {0, 0};
  }
  return {mean_ * effects::State::parabola(y / outline_.height()), 0};
}

std::array<double, 2> InitialVelocity::at(double x, double y) const {
  switch (flow_) {
    case InitialFlow::developed:
      return developed(x, y);
    case InitialFlow::taylor_green: {
      const double kx = 2 * std::numbers::pi / outline_.length();
      const double ky = 2 * std::numbers::pi / outline_.height();
      return {-std::cos(kx * x) * std::sin(ky * y), kx / ky * std::sin(kx * x) * std::cos(ky * y)};
    }
    default:
      return {0, 0};
  }
}

double InitialVelocity::pressure(double x, double y) const {
  if (flow_ == InitialFlow::rest) return weight_[0] * x + weight_[1] * y;
  if (flow_ != InitialFlow::taylor_green) return 0;
  const double kx = 2 * std::numbers::pi / outline_.length();
  const double ky = 2 * std::numbers::pi / outline_.height();
  return -(std::cos(2 * kx * x) + kx * kx / (ky * ky) * std::cos(2 * ky * y)) / 4;
}

}  // namespace rouleau
