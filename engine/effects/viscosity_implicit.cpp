#include "engine/effects/viscosity_implicit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/effects/backward_difference.h"
#include "engine/error/simulation_error.h"
#include "engine/linear/bicgstab.h"

namespace rouleau::effects {

namespace {

// Relative to the norm of the velocities over ten; a looser one lets membranes leak.
constexpr double tolerance = 1e-4;
constexpr int max_iterations = 500;

class ViscosityImplicit : public Effect {
 public:
  void apply(State& state) override {
    assemble(state);
    const auto& particles = state.particles;
    double norm2 = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
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
  /// Rows scaled by their diagonal, on the pattern of the neighbour list: pairs with walls and buffers have
  /// weight 0, as their velocities do not change. The right-hand side is the residual of the present
  /// velocities, so that the unknown is their change.
  void assemble(State& state) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const float* laplacian = state.operators.laplacian().data();
    const int n = particles.active_end();
    const double dt = state.dt;
    const BackwardDifference in_time(state.dt, state.last_dt);
    const double diffusion = in_time.weight * dt * state.viscosity;
    weight_.resize(list.j.size());
    inverse_diagonal_.resize(n);
    // Padded to all that a pair can point to.
    const auto length = 2 * static_cast<std::size_t>(particles.velocity_end());
    residual_.assign(length, 0);
    change_.assign(length, 0);
    rate_.assign(length, 0);
    velocity_.resize(length);
    for (int i = 0; i < particles.velocity_end(); ++i) {
      velocity_[2 * i] = particles.u[i];
      velocity_[2 * i + 1] = particles.v[i];
    }
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(velocity_.data(), rate_.data());
    for (int i = 0; i < n; ++i) {
      const int begin = list.begin(i), end = list.end(i);
      const int* j = list.j.data();
      const double* velocity = velocity_.data();
      const double u = velocity[2 * i], v = velocity[2 * i + 1];
      double sum = 0, lu = 0, lv = 0;
#pragma omp simd reduction(+ : sum, lu, lv)
      for (int k = begin; k < end; ++k) {
        sum += laplacian[k];
        lu += laplacian[k] * (velocity[2 * j[k]] - u);
        lv += laplacian[k] * (velocity[2 * j[k] + 1] - v);
      }
      const double inverse = 1 / (1 + diffusion * sum);
      const auto scale = static_cast<float>(-diffusion * inverse);
      float* weight = weight_.data();
#pragma omp simd
      for (int k = begin; k < end; ++k) weight[k] = j[k] < n ? scale * laplacian[k] : 0.0F;
      inverse_diagonal_[i] = inverse;
      const operators::Gradient gp = state.operators.pressure_gradient(i, particles.p.data());
      const double g = in_time.weight, h = in_time.history;
      residual_[2 * i] = inverse * (g * dt * (state.ax[i] - gp.x) + h * particles.du[i] + diffusion * lu +
                                    g * dt * dt * rate_[2 * i]);
      residual_[2 * i + 1] = inverse * (g * dt * (state.ay[i] - gp.y) + h * particles.dv[i] + diffusion * lv +
                                        g * dt * dt * rate_[2 * i + 1]);
    }
  }

  void multiply(const State& state, std::span<const double> in, std::span<double> out) {
    const auto& list = state.neighbours;
    const int n = list.rows();
    const int* j = list.j.data();
    const float* weight = weight_.data();
    const double* from = in.data();
    for (int i = 0; i < n; ++i) {
      // Both components of a neighbour lie side by side: one load each. Four sums at once, since each is a
      // chain of dependent additions.
      std::array<double, 8> sum{from[2 * i], from[2 * i + 1]};
      const int end = list.end(i);
      int k = list.begin(i);
      for (; k + 4 <= end; k += 4) {
        for (int lane = 0; lane < 4; ++lane) {
          sum[2 * lane] += weight[k + lane] * from[2 * j[k + lane]];
          sum[2 * lane + 1] += weight[k + lane] * from[2 * j[k + lane] + 1];
        }
      }
      for (; k < end; ++k) {
        sum[0] += weight[k] * from[2 * j[k]];
        sum[1] += weight[k] * from[2 * j[k] + 1];
      }
      out[2 * i] = (sum[0] + sum[2]) + (sum[4] + sum[6]);
      out[2 * i + 1] = (sum[1] + sum[3]) + (sum[5] + sum[7]);
    }
    std::fill(out.begin() + 2 * n, out.end(), 0.0);
    if (state.implicit_forces.empty()) return;
    std::fill(rate_.begin(), rate_.end(), 0.0);
    for (const ImplicitForce* force : state.implicit_forces) force->add_rate(from, rate_.data());
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
  std::vector<float> weight_;
  std::vector<double> inverse_diagonal_, residual_, change_, velocity_, rate_;
};

}  // namespace

const EffectKind viscosity_implicit{
    "viscosity_implicit", Stage::viscosity, false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "plasma is viscous", "/plasma/kinematic_viscosity"});
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ViscosityImplicit>(); }};

}  // namespace rouleau::effects
