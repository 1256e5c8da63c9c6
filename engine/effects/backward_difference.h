#pragma once

namespace rouleau::effects {

/// The second-order backward difference along a particle's path with steps of any length: with the changes
/// d = u(n+1) - u(n) and D = u(n) - u(n-1),  d = weight dt du/dt(n+1) + history D. The first step, which
/// has no history, is backward Euler.
struct BackwardDifference {
  double weight = 1;
  double history = 0;

  BackwardDifference(double dt, double last_dt) {
    if (last_dt <= 0) return;
    const double ratio = dt / last_dt;
    weight = (1 + ratio) / (1 + 2 * ratio);
    history = ratio * ratio / (1 + 2 * ratio);
  }
};

}  // namespace rouleau::effects
