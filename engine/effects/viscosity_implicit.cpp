#include "engine/effects/viscosity_implicit.h"

#include <cmath>

#include "engine/effects/backward_difference.h"
#include "engine/effects/breach.h"
#include "engine/linear/aggregates.h"
#include "engine/linear/bicgstab.h"
#include "engine/linear/coarse_space.h"

namespace rouleau::effects {

namespace {

// Error of the change, as the preconditioned residual shows it, relative to the norm of the velocities.
constexpr double tolerance = 1e-5;
constexpr int max_iterations = 500;
constexpr double aggregate_width = 5;  // spacings

class ViscosityImplicit : public Effect {
 public:
  explicit ViscosityImplicit(const State& state)
      : aggregates_(aggregate_width * state.spacing, state.outline.period_x(), state.outline.period_y()) {}

  void apply(State& state) override {
    assemble(state);
    const auto& particles = state.particles;
    double norm2 = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
      change_[2 * i] = static_cast<float>(particles.du[i]);
      change_[2 * i + 1] = static_cast<float>(particles.dv[i]);
      norm2 += particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
    }
    const linear::Solve solve =
        solver_.solve([&](std::span<const float> in, std::span<float> out) { multiply(state, in, out); },
                      residual_, change_, tolerance * (std::sqrt(norm2) + 1e-11), max_iterations);
    state.counters.viscosity_iterations += solve.iterations;
    if (!solve.converged) throw unsolved(state, "viscous step", solve);
    update(state);
  }

 private:
  /// The right-hand side is the residual of the present velocities, so that the unknown is their change: a
  /// small one, for which float will do. Pairs with walls and buffers count for nothing in the products, as
  /// their velocities do not change: the vectors are padded with zeros.
  void assemble(State& state) {
    const auto& particles = state.particles;
    const int n = particles.active_end();
    const double dt = state.dt;
    const BackwardDifference in_time(state.dt, state.last_dt);
    diffusion_ = in_time.weight * dt * state.viscosity;
    implicit_time_ = in_time.weight * dt;
    // Padded to all that a pair can point to.
    const auto length = 2 * static_cast<std::size_t>(particles.velocity_end());
    residual_.assign(length, 0);
    change_.assign(length, 0);
    response_at_first_.assign(length, 0);
    operators::interleave(particles.u, particles.v, velocity_);
    for (const ImplicitForce* force : state.implicit_forces) {
      force->add_response(velocity_.data(), dt, response_at_first_.data());
    }
    state.operators.velocity_laplacians(velocity_.data(), laplacian_, weights_);
    state.operators.pressure_gradients(particles.p.data(), slope_);
    diagonal_.resize(n);
    inverse_diagonal_.resize(n);
    for (int i = 0; i < n; ++i) {
      const double diagonal = 1 + diffusion_ * weights_[i];
      diagonal_[i] = static_cast<float>(diagonal);
      inverse_diagonal_[i] = static_cast<float>(1 / diagonal);
      const double force[2] = {state.ax[i], state.ay[i]}, last[2] = {particles.du[i], particles.dv[i]};
      for (int d = 0; d < 2; ++d) {
        const int k = 2 * i + d;
        residual_[k] =
            static_cast<float>(in_time.weight * dt * (force[d] - slope_[k]) + in_time.history * last[d] +
                               diffusion_ * laplacian_[k] + implicit_time_ * response_at_first_[k]);
      }
    }
    prepare_coarse(state);
    precondition(residual_);
  }

  /// out = M^-1 A in
  void multiply(const State& state, std::span<const float> in, std::span<float> out) {
    const int n = state.neighbours.rows();
    state.operators.laplacian_products(in.data(), out.data());
    const auto diffusion = static_cast<float>(diffusion_);
    for (int i = 0; i < n; ++i) {
      out[2 * i] = diagonal_[i] * in[2 * i] - diffusion * out[2 * i];
      out[2 * i + 1] = diagonal_[i] * in[2 * i + 1] - diffusion * out[2 * i + 1];
    }
    std::fill(out.begin() + 2 * n, out.end(), 0.0F);
    if (!state.implicit_forces.empty()) {
      response_.assign(out.size(), 0);
      for (const ImplicitForce* force : state.implicit_forces) {
        force->add_response(in.data(), state.dt, response_.data());
      }
      const auto time = static_cast<float>(implicit_time_);
      for (int k = 0; k < 2 * n; ++k) out[k] -= time * response_[k];
    }
    precondition(out);
  }

  void prepare_coarse(const State& state) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const int n = particles.active_end();
    const auto count = static_cast<std::size_t>(n);
    of_ = &aggregates_.build({particles.x.data(), count}, {particles.y.data(), count});
    coarse_.reset(*of_);
    for (int i = 0; i < n; ++i) {
      const float* weight = state.operators.laplacian(i);
      const int a = of_->of[i];
      coarse_.add(a, a, 1 + diffusion_ * weights_[i]);
      for (int k = list.begin(i); k < list.end(i); ++k) {
        const int j = list.j[k];
        if (j < n) coarse_.add(a, of_->of[j], -diffusion_ * static_cast<double>(weight[k - list.begin(i)]));
      }
    }
    coarse_.factor();
  }

  /// Jacobi and the coarse space: what is left is near to the error.
  void precondition(std::span<float> residual) {
    const int n = static_cast<int>(diagonal_.size());
    for (int d = 0; d < 2; ++d) {
      const auto coarse = coarse_.correct(std::span<const float>(residual), 2, d);
      for (int i = 0; i < n; ++i) {
        float& r = residual[2 * i + d];
        r = r * inverse_diagonal_[i] + static_cast<float>(coarse[of_->of[i]]);
      }
    }
  }

  void update(State& state) const {
    auto& particles = state.particles;
    for (int i = 0; i < particles.active_end(); ++i) {
      particles.u[i] += static_cast<double>(change_[2 * i]);
      particles.v[i] += static_cast<double>(change_[2 * i + 1]);
    }
  }

  linear::BiCgStab<float> solver_;
  linear::GridAggregates aggregates_;
  const linear::Aggregates* of_ = nullptr;
  linear::CoarseSpace coarse_;
  double diffusion_ = 0, implicit_time_ = 0;
  std::vector<float> diagonal_, inverse_diagonal_, residual_, change_, response_;
  std::vector<double> velocity_, laplacian_, weights_, slope_, response_at_first_;
};

/// By the preconditioned residual, from runs: steady flow needs one or two, the disorder that a plug's
/// corners leave five, and membranes the more the farther a step would carry them past their rest.
double iterations(const Work& work) {
  const Case& scene = work.scene;
  const bool plug = is_open(scene.vessel) && scene.inflow.profile == Profile::plug;
  const double of_flow = plug ? 5.1 : scene.vessel.shape == Shape::bifurcation ? 3 : 2;
  // In a shear flow without ends a membrane turns at rest.
  const double of_membranes = (is_open(scene.vessel) ? 0.78 : 0.16) * std::pow(work.stiffness, 0.6);
  return of_flow + of_membranes;
}

double particles_times_iterations(const Work& work) {
  return work.particles * iterations(work);
}

}  // namespace

const EffectKind viscosity_implicit{
    "viscosity_implicit",
    Stage::viscosity,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "plasma is viscous", "/plasma/kinematic_viscosity"});
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<ViscosityImplicit>(state); },
    "",
    {},
    {.particle = 149, .each = 36, .count = particles_times_iterations}};

}  // namespace rouleau::effects
