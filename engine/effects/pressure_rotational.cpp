#include "engine/effects/pressure_rotational.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/backward_difference.h"
#include "engine/effects/breach.h"
#include "engine/linear/sparse_rows.h"
#include "engine/linear/two_level_cg.h"

namespace rouleau::effects {

namespace {

constexpr int max_iterations = 2000;
constexpr double aggregate_width = 5;  // spacings

/// Weight of the symmetric Laplacian, and its normalisation on a square lattice.
double weight(double q) {
  return q < 1 ? (1 - q) * (1 - q) : 0;
}

class PressureRotational : public Effect {
 public:
  explicit PressureRotational(const State& state)
      : aggregates_(aggregate_width * state.spacing, state.outline.period_x(), state.outline.period_y()) {
    double lambda = 0;
    const double reach = state.near_radius / state.spacing;
    for (int a = -4; a <= 4; ++a) {
      for (int b = -4; b <= 4; ++b) {
        const double r = std::hypot(a, b);
        if (r == 0 || r >= reach) continue;
        density_ += weight(r / reach);
        lambda += weight(r / reach) * r * r;
      }
    }
    laplacian_scale_ = 4 / (lambda * state.spacing * state.spacing);
  }

  void apply(State& state) override {
    find_divergence(state);
    assemble(state);
    const auto& particles = state.particles;
    const auto n = static_cast<std::size_t>(matrix_.rows());
    // Without an outlet nothing fixes the level of the pressure.
    const bool closed = particles.pressure_end() == particles.active_end();
    solver_.prepare(matrix_, aggregates_.build({particles.x.data(), n}, {particles.y.data(), n}),
                    closed ? linear::Constants::ignored : linear::Constants::seen);
    increment_.assign(particles.phi.begin(), particles.phi.begin() + matrix_.rows());
    const linear::Solve solve =
        solver_.solve(right_side_, increment_, state.scene.numerics.pressure_tolerance, max_iterations);
    state.counters.pressure_iterations += solve.iterations;
    if (!solve.converged) throw unsolved(state, "pressure equation", solve);
    correct(state);
  }

 private:
  void find_divergence(State& state) {
    const int n = state.particles.active_end();
    right_side_.resize(n);
    operators::interleave(state.particles.u, state.particles.v, velocity_);
    state.operators.divergences(velocity_.data(), excess_);
    const double step = BackwardDifference(state.dt, state.last_dt).weight * state.dt;
    for (int i = 0; i < n; ++i) {
      excess_[i] -= state.source[i];
      right_side_[i] = -excess_[i] / step;
    }
  }

  /// Minus the Laplacian over fluid pairs alone: walls are Neumann by truncation. Pairs with the outlet's
  /// buffer, where the increment is zero, stay on the diagonal. Where particles are sparse the weights are
  /// raised by n0 / n_i, or voids would let the increment overshoot.
  void assemble(const State& state) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const int n = particles.active_end();
    const int with_pressure = particles.pressure_end();
    weigh_pairs(state);
    for (int i = 0; i < n; ++i) {
      double diagonal = 0;
      int at = matrix_.begin[i];
      const int entries = at - list.begin(i);
      for (int k = list.begin(i); k < list.near_end(i); ++k) {
        const int j = list.j[k];
        if (j >= with_pressure) continue;
        const float a = matrix_.value[entries + k] * (density_scale_[i] + density_scale_[j]);
        diagonal += a;
        // An entry of the outlet's is overwritten by the next one.
        matrix_.column[at] = j;
        matrix_.value[at] = -a;
        at += j < n;
      }
      matrix_.pad(i, at);
      matrix_.diagonal[i] = diagonal > 0 ? diagonal : 1;
    }
  }

  /// Puts the near pairs' weights where the matrix will have its entries, and sums them to densities.
  void weigh_pairs(const State& state) {
    const auto& list = state.neighbours;
    const auto inverse_reach = static_cast<float>(1 / state.near_radius);
    const auto scale = static_cast<float>(0.5 * laplacian_scale_);
    matrix_.lay_out(list.rows(), [&](int i) { return list.near_end(i) - list.begin(i); });
    density_scale_.assign(state.particles.pressure_end(), 1);
    for (int i = 0; i < list.rows(); ++i) {
      const int n = list.near_end(i) - list.begin(i);
      const float* r = list.r.data() + list.begin(i);
      float* out = matrix_.value.data() + matrix_.begin[i];
      float density = 0;
      for (int k = 0; k < n; ++k) {
        const float q = std::max(1 - r[k] * inverse_reach, 0.0F);
        density += q * q;
        out[k] = scale * (q * q);
      }
      for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) {
        const float q = std::max(1 - list.ghost_r[k] * inverse_reach, 0.0F);
        density += q * q;
      }
      density_scale_[i] = std::clamp(static_cast<float>(density_) / std::max(density, 1e-9F), 1.0F, 4.0F);
    }
  }

  void correct(State& state) {
    auto& particles = state.particles;
    const int n = matrix_.rows();
    const double step = BackwardDifference(state.dt, state.last_dt).weight * state.dt;
    for (int i = 0; i < n; ++i) particles.phi[i] = increment_[i];
    for (int i = n; i < particles.size(); ++i) particles.phi[i] = 0;
    state.operators.pressure_gradients(particles.phi.data(), gradients_);
    for (int i = 0; i < n; ++i) {
      particles.u[i] -= step * gradients_[2 * i];
      particles.v[i] -= step * gradients_[2 * i + 1];
      // The plasma's viscosity inside cells, too: by theirs, fifty times as large, velocity and pressure took
      // turns growing.
      particles.p[i] += particles.phi[i] - state.viscosity * excess_[i];
    }
  }

  double density_ = 0;
  double laplacian_scale_ = 0;
  linear::SparseRows matrix_;
  linear::GridAggregates aggregates_;
  linear::TwoLevelCg solver_;
  std::vector<float> density_scale_;
  std::vector<double> excess_, right_side_, increment_;
  std::vector<double> velocity_, gradients_;
};

/// From runs: with the coarse space neither size nor step matters.
double particles_times_iterations(const Work& work) {
  if (!is_open(work.scene.vessel)) return 11 * work.particles;
  return (work.scene.inflow.profile == Profile::plug ? 14.5 : 12.5) * work.particles;
}

}  // namespace

const EffectKind pressure_rotational{
    "pressure_rotational",
    Stage::pressure,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "plasma is incompressible", "/plasma"});
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<PressureRotational>(state); },
    "",
    {},
    {.particle = 167, .each = 9.7, .count = particles_times_iterations}};

}  // namespace rouleau::effects
