#include "engine/effects/transport.h"

#include <array>

namespace rouleau::effects {

namespace {

constexpr double smoothing = 0.2;  // of the roughness of pressure, a step

class Transport : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    const int n = particles.active_end();
    fields_.resize(4 * particles.u.size());
    for (int i = 0; i < particles.size(); ++i) {
      fields_[4 * i] = particles.u[i];
      fields_[4 * i + 1] = particles.v[i];
      fields_[4 * i + 2] = particles.p[i];
    }
    pressure_ = particles.p;
    leave_out_jumps(state);
    leave_out_corner_flow(state);
    state.operators.field_gradients(fields_.data(), pressure_.data(), gradients_);
    average_membranes(state);
    for (int i = 0; i < n; ++i) {
      // Derivatives of u, v and p.
      const double *dx = &gradients_[8 * i], *dy = dx + 4;
      state.pressure_gx[i] = dx[2];
      state.pressure_gy[i] = dy[2];
      if (i < particles.membrane_end()) continue;
      const double sx = state.shift_x[i], sy = state.shift_y[i];
      // The pressure field stands still, but beside a membrane it moves along with it.
      const double wx = sx + state.dt * (particles.u[i] - membrane_[2 * i]);
      const double wy = sy + state.dt * (particles.v[i] - membrane_[2 * i + 1]);
      particles.u[i] += sx * dx[0] + sy * dy[0];
      particles.v[i] += sx * dx[1] + sy * dy[1];
      particles.p[i] += wx * dx[2] + wy * dy[2];
      if (state.corner_flow) carry_corner_flow(state, i, {sx, sy}, {wx, wy});
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
  /// Across a membrane pressure jumps: a fit through both sides makes a slope of it, along which a particle
  /// that is shifted would lose or gain pressure without end. So the fits are of p without each cell's mean
  /// jump, between the particles next to its nodes.
  void leave_out_jumps(const State& state) {
    const auto& particles = state.particles;
    const int nodes_end = particles.membrane_end(), n = particles.active_end();
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      const auto cell = static_cast<int>(c);
      const double jump = mean_jump(state, cell);
      for (int i = 0; i < n; ++i) {
        if (particles.cell[i] != cell) continue;
        fields_[4 * i + 2] -= i < nodes_end ? jump / 2 : jump;
        pressure_[i] = fields_[4 * i + 2];
      }
    }
  }

  static double mean_jump(const State& state, int cell) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const CellState& of = state.cells[cell];
    double inside = 0, outside = 0;
    int within = 0, without = 0;
    for (int node = of.first_node; node < of.first_node + of.nodes; ++node) {
      for (int k = list.begin(node); k < list.near_end(node); ++k) {
        const int j = list.j[k];
        if (j < particles.membrane_end() || j >= particles.active_end()) continue;
        const bool enclosed = particles.cell[j] == cell;
        (enclosed ? inside : outside) += particles.p[j];
        ++(enclosed ? within : without);
      }
    }
    return within > 0 && without > 0 ? inside / within - outside / without : 0;
  }

  /// Beside the corners of moving walls only what differs from the flow that is known there is fitted.
  void leave_out_corner_flow(const State& state) {
    if (!state.corner_flow) return;
    const auto& particles = state.particles;
    for (int i = 0; i < particles.velocity_end(); ++i) {
      const operators::KnownFlow known = state.corner_flow->at(particles.x[i], particles.y[i]);
      fields_[4 * i] -= known.u;
      fields_[4 * i + 1] -= known.v;
      fields_[4 * i + 2] -= state.viscosity * known.p;
      pressure_[i] = fields_[4 * i + 2];
    }
  }

  /// What the known flow changes over the displacements of velocity and of pressure.
  static void carry_corner_flow(State& state, int i, const std::array<double, 2>& s,
                                const std::array<double, 2>& w) {
    auto& particles = state.particles;
    const double x = particles.x[i], y = particles.y[i];
    const auto here = state.corner_flow->at(x, y), there = state.corner_flow->at(x + s[0], y + s[1]);
    particles.u[i] += there.u - here.u;
    particles.v[i] += there.v - here.v;
    particles.p[i] += state.viscosity * (state.corner_flow->at(x + w[0], y + w[1]).p - here.p);
  }

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
                  (fields_[4 * j + 2] - fields_[4 * i + 2] -
                   0.5 * ((state.pressure_gx[i] + state.pressure_gx[j]) * list.dx[k] +
                          (state.pressure_gy[i] + state.pressure_gy[j]) * list.dy[k]));
      }
      if (weight > 0) particles.p[i] += smoothing * excess / weight;
    }
  }

  /// For each active particle the mean velocity of the membrane nodes near it, 0 where there is none.
  void average_membranes(const State& state) {
    const auto& list = state.neighbours;
    const int n = list.rows();
    membrane_.assign(2 * static_cast<std::size_t>(n), 0);
    nodes_.assign(n, 0);
    for (int node = 0; node < state.particles.membrane_end(); ++node) {
      for (int k = list.begin(node); k < list.end(node); ++k) {
        const int i = list.j[k];
        if (i >= n) continue;
        membrane_[2 * i] += state.particles.u[node];
        membrane_[2 * i + 1] += state.particles.v[node];
        ++nodes_[i];
      }
    }
    for (int i = 0; i < n; ++i) {
      if (nodes_[i] == 0) continue;
      membrane_[2 * i] /= nodes_[i];
      membrane_[2 * i + 1] /= nodes_[i];
    }
  }

  std::vector<double> fields_, pressure_, gradients_, membrane_;
  std::vector<int> nodes_;
};

}  // namespace

const EffectKind transport{
    "transport",
    Stage::motion,
    false,
    [](const Case& scene) { return of_accurate_scheme(scene, always("velocity and pressure are fields")); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Transport>(); },
    "",
    {},
    {.particle = 94}};

}  // namespace rouleau::effects
