#include "engine/simulation/step_control.h"

#include <algorithm>
#include <cmath>

namespace rouleau {

namespace {

// The explicit transport of pressure is unstable from |u| dt / d0 = 0.7 on.
constexpr double largest_courant = 0.5;
// Of d0^2/nu, for each viscous sub-step: 0.35 is the bound of eq. 6 at 2.1 d0.
constexpr double largest_substep = 0.3;
// By what part of its length a link may stretch in a step.
constexpr double largest_stretch = 0.15;
// Change of velocity in a step, relative; the local error of the implicit step is half its square.
constexpr double largest_change = 0.1;
// No error makes a step smaller than the planned one over this.
constexpr double error_range = 64;
constexpr double growth = 1.25;
constexpr int most_rejections = 8;
// Of the planned step: where accepted steps crowd below it, none cures the breach that each next one meets.
constexpr double least_step = 1.0 / 4096;

double stretching_rate(const effects::State& state) {
  const auto& p = state.particles;
  double rate = 0;
  for (const effects::CellState& cell : state.cells) {
    for (int q = 0; q < cell.nodes; ++q) {
      const int a = cell.first_node + q;
      const int b = cell.first_node + (q + 1) % cell.nodes;
      const double dx = p.x[b] - p.x[a], dy = p.y[b] - p.y[a];
      rate = std::max(rate, std::abs((p.u[b] - p.u[a]) * dx + (p.v[b] - p.v[a]) * dy) / (dx * dx + dy * dy));
    }
  }
  return rate;
}

}  // namespace

std::string_view name_of(Limit limit) {
  static constexpr std::array<std::string_view, limits> names{"planned", "flow",     "viscous", "elastic",
                                                              "error",   "rejected", "end"};
  return names[static_cast<std::size_t>(limit)];
}

double StepControl::choose(const effects::State& state) {
  double dt = planned_;
  limit_ = Limit::planned;
  const auto hold = [&](double bound, Limit limit) {
    if (bound >= dt) return;
    dt = bound;
    limit_ = limit;
  };
  const Numerics& numerics = state.scene.numerics;
  if (numerics.viscosity == Viscosity::substeps) {
    hold(numerics.substeps * largest_substep * state.spacing * state.spacing / state.viscosity,
         Limit::viscous);
  }
  hold(duration_ - state.time, Limit::end);
  if (fixed_) return dt;
  hold(largest_courant * state.spacing / std::max(state.speed, 1e-30), Limit::flow);
  if (!state.cells.empty()) hold(largest_stretch / std::max(stretching_rate(state), 1e-30), Limit::elastic);
  hold(allowed_by_error_, Limit::error);
  hold(allowed_after_rejection_, Limit::rejected);
  return dt;
}

bool StepControl::accurate(double dt, double change) const {
  return fixed_ || change <= 2 * largest_change || dt <= planned_ / error_range;
}

void StepControl::accept(double dt, double change) {
  ++counts_.bound[static_cast<std::size_t>(limit_)];
  if (limit_ != Limit::end) {
    counts_.least = counts_.most > 0 ? std::min(counts_.least, dt) : dt;
    counts_.most = std::max(counts_.most, dt);
  }
  allowed_by_error_ =
      std::max(dt * std::min(growth, largest_change / std::max(change, 1e-30)), planned_ / error_range);
  allowed_after_rejection_ *= growth;
  rejections_in_a_row_ = 0;
}

bool StepControl::reject(double dt, const std::string& cause) {
  if (fixed_) return false;
  ++counts_.rejected;
  const auto known = std::ranges::find(counts_.rejections, cause, &Rejection::cause);
  if (known != counts_.rejections.end()) {
    ++known->steps;
  } else {
    counts_.rejections.push_back({cause, 1});
  }
  allowed_after_rejection_ = dt / 2;
  return ++rejections_in_a_row_ <= most_rejections && dt > least_step * planned_;
}

}  // namespace rouleau
