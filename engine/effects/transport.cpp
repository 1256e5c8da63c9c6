#include "engine/effects/transport.h"

namespace rouleau::effects {

namespace {

constexpr double smoothing = 0.2;  // of the roughness of pressure, a step

class Transport : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    const int n = particles.active_end();
    u_ = particles.u;
    v_ = particles.v;
    p_ = particles.p;
    for (int i = 0; i < n; ++i) {
      const operators::Gradient gu = state.operators.velocity_gradient(i, u_.data());
      const operators::Gradient gv = state.operators.velocity_gradient(i, v_.data());
      const operators::Gradient gp = state.operators.pressure_gradient(i, p_.data());
      state.pressure_gx[i] = gp.x;
      state.pressure_gy[i] = gp.y;
      if (i < particles.membrane_end()) continue;
      const double sx = state.shift_x[i], sy = state.shift_y[i];
      particles.u[i] += sx * gu.x + sy * gu.y;
      particles.v[i] += sx * gv.x + sy * gv.y;
      // The pressure field stands still, but beside a membrane it moves along with it.
      const operators::Gradient field = membrane_velocity(state, i);
      particles.p[i] +=
          (sx + state.dt * (u_[i] - field.x)) * gp.x + (sy + state.dt * (v_[i] - field.y)) * gp.y;
    }
    smooth_pressure(state);
    for (int i = 0; i < particles.inlet_end(); ++i) {
      particles.x[i] = state.next_x[i];
      particles.y[i] = state.next_y[i];
    }
    for (int i = particles.membrane_end(); i < n; ++i) {
      particles.x[i] += state.shift_x[i];
      particles.y[i] += state.shift_y[i];
    }
  }

 private:
  /// Takes out what no gradient sees: the part of p that differs from the neighbours' by more than the mean
  /// of both gradients leads to (Antuono et al. 2010 do so to a density). It would grow beside walls, where
  /// gradient and divergence are not adjoint. Exact for quadratic fields; not across membranes, where
  /// pressure jumps.
  void smooth_pressure(State& state) const {
    auto& particles = state.particles;
    const auto& list = state.neighbours;
    const int n = particles.active_end();
    const int first = particles.membrane_end();
    for (int i = first; i < n; ++i) {
      double excess = 0, weight = 0;
      for (int k = list.begin(i); k < list.near_end(i); ++k) {
        const int j = list.j[k];
        if (j < first || j >= n || particles.cell[j] != particles.cell[i]) continue;
        const double q = 1 - list.r[k] / state.near_radius;
        weight += q * q;
        excess += q * q *
                  (p_[j] - p_[i] -
                   0.5 * ((state.pressure_gx[i] + state.pressure_gx[j]) * list.dx[k] +
                          (state.pressure_gy[i] + state.pressure_gy[j]) * list.dy[k]));
      }
      if (weight > 0) particles.p[i] += smoothing * excess / weight;
    }
  }

  operators::Gradient membrane_velocity(const State& state, int i) const {
    const auto& list = state.neighbours;
    operators::Gradient sum;
    int count = 0;
    for (int k = list.begin(i); k < list.end(i); ++k) {
      const int j = list.j[k];
      if (j >= state.particles.membrane_end()) continue;
      sum.x += u_[j];
      sum.y += v_[j];
      ++count;
    }
    if (count == 0) return {};
    return {sum.x / count, sum.y / count};
  }

  std::vector<double> u_, v_, p_;
};

}  // namespace

const EffectKind transport{
    "transport", Stage::motion, false,
    [](const Case& scene) { return of_accurate_scheme(scene, always("velocity and pressure are fields")); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Transport>(); }};

}  // namespace rouleau::effects
