#include "engine/observe/cross_section.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace rouleau::observe {

namespace {

using effects::State;

/// Value at (x, y) of a quadratic fitted to a field on the given particles; a plain weighted mean where they
/// do not carry a quadratic.
double fit(const State& state, const std::vector<int>& candidates, const std::vector<double>& field, double x,
           double y) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  for (const int i : candidates) {
    const double X = (state.particles.x[i] - x) / state.radius;
    const double Y = (state.particles.y[i] - y) / state.radius;
    const double r = std::hypot(X, Y);
    if (r >= 1) continue;
    const double w = (1 - r) * (1 - r);
    Eigen::Matrix<double, 6, 1> basis;
    basis << 1, X, Y, X * X, X * Y, Y * Y;
    normal += w * basis * basis.transpose();
    right += w * field[i] * basis;
  }
  if (normal(0, 0) <= 0) return 0;
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(normal);
  if (factor.rcond() < 1e-9) return right(0) / normal(0, 0);
  return factor.solve(right)(0);
}

std::vector<int> particles_near(const State& state, double x, int end) {
  std::vector<int> near;
  for (int i = 0; i < end; ++i) {
    if (std::abs(state.particles.x[i] - x) < state.radius) near.push_back(i);
  }
  return near;
}

}  // namespace

CrossSection measure_cross_section(const State& state, double x) {
  const auto moving = particles_near(state, x, state.particles.velocity_end());
  const auto with_pressure = particles_near(state, x, state.particles.pressure_end());
  const int panels = 2 * (state.rows() + 1);
  CrossSection section;
  for (int k = 0; k <= panels; ++k) {
    const double y = state.outline.height() * k / panels;
    const double simpson = (k == 0 || k == panels ? 1 : k % 2 ? 4 : 2) / (3.0 * panels);
    section.flux += simpson * state.outline.height() * fit(state, moving, state.particles.u, x, y);
    section.pressure += simpson * fit(state, with_pressure, state.particles.p, x, y);
  }
  return section;
}

}  // namespace rouleau::observe
