#include "engine/effects/viscosity_implicit.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/backward_difference.h"
#include "engine/error/simulation_error.h"
#include "engine/linear/bicgstab.h"

namespace rouleau::effects {

namespace {

// Of the residual, relative to the norm of the velocities. Rows are scaled by their diagonal, by which a
// smooth error comes out larger than its residual: without that factor flows from rest got worse with
// resolution. A looser tolerance lets membranes leak.
constexpr double tolerance = 3e-5;
constexpr double loosest = 1e-5;
constexpr int max_iterations = 500;

class ViscosityImplicit : public Effect {
 public:
  void apply(State& state) override {
    assemble(state);
    const auto& particles = state.particles;
    double norm2 = 0, inverse_diagonal = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
      change_[2 * i] = particles.du[i];
      change_[2 * i + 1] = particles.dv[i];
      norm2 += particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
      inverse_diagonal += inverse_diagonal_[i] / particles.active_end();
    }
    const double relative = std::min(loosest, tolerance * inverse_diagonal);
    const linear::Solve solve =
        solver_.solve([&](std::span<const double> in, std::span<double> out) { multiply(state, in, out); },
                      residual_, change_, relative * (std::sqrt(norm2) + 1e-11), max_iterations);
    state.counters.viscosity_iterations += solve.iterations;
    if (!solve.converged) throw_unsolved(state, solve);
    update(state);
  }

 private:
  /// Rows scaled by their diagonal. Pairs with walls and buffers count for nothing in the products, as their
  /// velocities do not change: the vectors are padded with zeros. The right-hand side is the residual of the
  /// present velocities, so that the unknown is their change.
  void assemble(State& state) {
    const auto& particles = state.particles;
    const int n = particles.active_end();
    const double dt = state.dt;
    const BackwardDifference in_time(state.dt, state.last_dt);
    const double diffusion = in_time.weight * dt * state.viscosity;
    inverse_diagonal_.resize(n);
    // Padded to all that a pair can point to.
    const auto length = 2 * static_cast<std::size_t>(particles.velocity_end());
    residual_.assign(length, 0);
    change_.assign(length, 0);
    rate_.assign(length, 0);
    operators::interleave(particles.u, particles.v, velocity_);
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(velocity_.data(), rate_.data());
    state.operators.velocity_laplacians(velocity_.data(), laplacian_, weights_);
    state.operators.pressure_gradients(particles.p.data(), slope_);
    for (int i = 0; i < n; ++i) {
      inverse_diagonal_[i] = 1 / (1 + diffusion * weights_[i]);
      const double force[2] = {state.ax[i], state.ay[i]}, last[2] = {particles.du[i], particles.dv[i]};
      for (int d = 0; d < 2; ++d) {
        const int k = 2 * i + d;
        residual_[k] =
            inverse_diagonal_[i] * (in_time.weight * dt * (force[d] - slope_[k]) + in_time.history * last[d] +
                                    diffusion * laplacian_[k] + in_time.weight * dt * dt * rate_[k]);
      }
    }
  }

  void multiply(const State& state, std::span<const double> in, std::span<double> out) {
    const int n = state.neighbours.rows();
    state.operators.laplacian_products(in.data(), out.data());
    const double diffusion = BackwardDifference(state.dt, state.last_dt).weight * state.dt * state.viscosity;
    for (int i = 0; i < n; ++i) {
      const double scale = -diffusion * inverse_diagonal_[i];
      out[2 * i] = in[2 * i] + scale * out[2 * i];
      out[2 * i + 1] = in[2 * i + 1] + scale * out[2 * i + 1];
    }
    std::fill(out.begin() + 2 * n, out.end(), 0.0);
    if (state.implicit_forces.empty()) return;
    std::fill(rate_.begin(), rate_.end(), 0.0);
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(in.data(), rate_.data());
    const double dt2 = BackwardDifference(state.dt, state.last_dt).weight * state.dt * state.dt;
    for (int i = 0; i < n; ++i) {
      out[2 * i] -= dt2 * inverse_diagonal_[i] * rate_[2 * i];
      out[2 * i + 1] -= dt2 * inverse_diagonal_[i] * rate_[2 * i + 1];
    }
  }

  void update(State& state) const {
    auto& particles = state.particles;
    for (int i = 0; i < particles.active_end(); ++i) {
      particles.u[i] += change_[2 * i];
      particles.v[i] += change_[2 * i + 1];
    }
  }

  static void throw_unsolved(const State& state, const linear::Solve& solve) {
    throw SimulationError({.quantity = "residual of the viscous step",
                           .value = solve.residual,
                           .bound = solve.goal,
                           .unit = "1",
                           .time = state.time * state.scales.time(),
                           .step = state.step});
  }

  linear::BiCgStab solver_;
  std::vector<double> inverse_diagonal_, weights_, residual_, change_, velocity_, rate_;
  std::vector<double> laplacian_, slope_;
};

}  // namespace

const EffectKind viscosity_implicit{
    "viscosity_implicit", Stage::viscosity, false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "plasma is viscous", "/plasma/kinematic_viscosity"});
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ViscosityImplicit>(); }};

}  // namespace rouleau::effects
