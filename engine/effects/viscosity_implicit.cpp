#include "engine/effects/viscosity_implicit.h"

#include <cmath>

#include "engine/error/simulation_error.h"
#include "engine/linear/bicgstab.h"
#include "engine/linear/sparse_rows.h"

namespace rouleau::effects {

namespace {

// Relative to the norm of the velocities over ten; a looser one lets membranes leak.
constexpr double tolerance = 1e-4;
constexpr int max_iterations = 500;

class ViscosityImplicit : public Effect {
 public:
  void apply(State& state) override {
    assemble(state);
    const int n = matrix_.rows();
    const auto& particles = state.particles;
    double norm2 = 0;
    change_.resize(2 * n);
    for (int i = 0; i < n; ++i) {
      change_[2 * i] = particles.du[i];
      change_[2 * i + 1] = particles.dv[i];
      norm2 += particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
    }
    const linear::Solve solve =
        solver_.solve([&](std::span<const double> in, std::span<double> out) { multiply(state, in, out); },
                      residual_, change_, tolerance * (std::sqrt(norm2) / 10 + 1e-12), max_iterations);
    state.counters.viscosity_iterations += solve.iterations;
    if (!solve.converged) throw_unsolved(state, solve);
    update(state);
  }

 private:
  /// Rows scaled by their diagonal; the right-hand side is the residual of the present velocities, so that
  /// the unknown is their change.
  void assemble(State& state) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const auto& laplacian = state.operators.laplacian();
    const int n = particles.active_end();
    const double dt = state.dt;
    const double diffusion = dt * state.viscosity;
    matrix_.clear();
    inverse_diagonal_.resize(n);
    residual_.assign(2 * n, 0);
    rate_.assign(2 * n, 0);
    velocity_.resize(2 * n);
    for (int i = 0; i < n; ++i) {
      velocity_[2 * i] = particles.u[i];
      velocity_[2 * i + 1] = particles.v[i];
    }
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(velocity_.data(), rate_.data());
    for (int i = 0; i < n; ++i) {
      double diagonal = 1, lu = 0, lv = 0;
      for (int k = list.begin(i); k < list.end(i); ++k) {
        const int j = list.j[k];
        diagonal += diffusion * laplacian[k];
        lu += laplacian[k] * (particles.u[j] - particles.u[i]);
        lv += laplacian[k] * (particles.v[j] - particles.v[i]);
      }
      const double inverse = 1 / diagonal;
      for (int k = list.begin(i); k < list.end(i); ++k) {
        if (list.j[k] < n) matrix_.add(list.j[k], static_cast<float>(-diffusion * laplacian[k] * inverse));
      }
      matrix_.end_row(1);
      inverse_diagonal_[i] = inverse;
      const operators::Gradient gp = state.operators.pressure_gradient(i, particles.p.data());
      residual_[2 * i] = inverse * (dt * (state.ax[i] - gp.x) + diffusion * lu + dt * dt * rate_[2 * i]);
      residual_[2 * i + 1] =
          inverse * (dt * (state.ay[i] - gp.y) + diffusion * lv + dt * dt * rate_[2 * i + 1]);
    }
  }

  void multiply(const State& state, std::span<const double> in, std::span<double> out) {
    const int n = matrix_.rows();
    const int* column = matrix_.column.data();
    const float* value = matrix_.value.data();
    for (int i = 0; i < n; ++i) {
      double u = in[2 * i], v = in[2 * i + 1];
#pragma omp simd reduction(+ : u, v)
      for (int k = matrix_.begin[i]; k < matrix_.begin[i + 1]; ++k) {
        u += value[k] * in[2 * column[k]];
        v += value[k] * in[2 * column[k] + 1];
      }
      out[2 * i] = u;
      out[2 * i + 1] = v;
    }
    if (state.implicit_forces.empty()) return;
    rate_.assign(2 * n, 0);
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(in.data(), rate_.data());
    const double dt2 = state.dt * state.dt;
    for (int i = 0; i < n; ++i) {
      out[2 * i] -= dt2 * inverse_diagonal_[i] * rate_[2 * i];
      out[2 * i + 1] -= dt2 * inverse_diagonal_[i] * rate_[2 * i + 1];
    }
  }

  void update(State& state) const {
    auto& particles = state.particles;
    for (int i = 0; i < matrix_.rows(); ++i) {
      particles.du[i] = change_[2 * i];
      particles.dv[i] = change_[2 * i + 1];
      particles.u[i] += change_[2 * i];
      particles.v[i] += change_[2 * i + 1];
    }
  }

  static void throw_unsolved(const State& state, const linear::Solve& solve) {
    throw SimulationError({.quantity = "residual of the viscous step",
                           .value = solve.residual,
                           .bound = tolerance,
                           .unit = "1",
                           .time = state.time * state.scales.time(),
                           .step = state.step});
  }

  linear::SparseRows matrix_;
  linear::BiCgStab solver_;
  std::vector<double> inverse_diagonal_, residual_, change_, velocity_, rate_;
};

}  // namespace

const EffectKind viscosity_implicit{
    "viscosity_implicit", Stage::viscosity, false,
    [](const Case&) {
      return Need{true, "plasma is viscous", "/plasma/kinematic_viscosity"};
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ViscosityImplicit>(); }};

}  // namespace rouleau::effects
