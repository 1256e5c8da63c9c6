#include "engine/effects/membrane_coupling.h"

#include <algorithm>
#include <cmath>

namespace rouleau::effects {

namespace {

constexpr double tangential_range = 1.6;  // spacings

/// Share of one node's force that one particle receives: an acceleration per acceleration of the node.
struct Share {
  int particle;
  double xx, xy, yx, yy;
};

/// The transfer S of numerics.md: rebuilt every step, and applied to the forces as they are and, as an
/// implicit force, to what the membranes' stiffness makes of the velocities.
class MembraneCoupling : public Effect, public ImplicitForce {
 public:
  void apply(State& state) override {
    build(state);
    const double per_mass = 1 / (state.spacing * state.spacing);
    const int nodes = state.particles.membrane_end();
    for (int node = 0; node < nodes; ++node) {
      const double ax = state.load.fx[node] * per_mass;
      const double ay = state.load.fy[node] * per_mass;
      for (int k = begin_[node]; k < begin_[node + 1]; ++k) {
        const Share& share = shares_[k];
        state.ax[share.particle] += share.xx * ax + share.xy * ay;
        state.ay[share.particle] += share.yx * ax + share.yy * ay;
      }
    }
    stiffness_ = &state.load.stiffness;
    per_mass_ = per_mass;
    state.implicit_forces.push_back(this);
  }

  void add_rate(const double* velocity, double* acceleration) const override {
    add_rate_of(velocity, acceleration);
  }
  void add_rate(const float* velocity, float* acceleration) const override {
    add_rate_of(velocity, acceleration);
  }

 private:
  template <class Real>
  void add_rate_of(const Real* velocity, Real* acceleration) const {
    node_rate_.assign(2 * (begin_.size() - 1), 0);
    for (const cells::Stiffness& element : *stiffness_) {
      double along = 0;
      for (int q = 0; q < 3; ++q) {
        along += element.g[2 * q] * velocity[2 * element.node[q]] +
                 element.g[2 * q + 1] * velocity[2 * element.node[q] + 1];
      }
      along *= -element.k * per_mass_;
      for (int q = 0; q < 3; ++q) {
        node_rate_[2 * element.node[q]] += along * element.g[2 * q];
        node_rate_[2 * element.node[q] + 1] += along * element.g[2 * q + 1];
      }
    }
    for (std::size_t node = 0; node + 1 < begin_.size(); ++node) {
      const double rx = node_rate_[2 * node];
      const double ry = node_rate_[2 * node + 1];
      for (int k = begin_[node]; k < begin_[node + 1]; ++k) {
        const Share& share = shares_[k];
        acceleration[2 * share.particle] += static_cast<Real>(share.xx * rx + share.xy * ry);
        acceleration[2 * share.particle + 1] += static_cast<Real>(share.yx * rx + share.yy * ry);
      }
    }
  }

  void build(const State& state) {
    begin_.assign(1, 0);
    shares_.clear();
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      weigh_colour(state, static_cast<int>(c));
      for (int q = 0; q < state.cells[c].nodes; ++q) share_out(state, state.cells[c], q);
    }
  }

  /// Each cell has its own colour (1 inside it, 1/2 on its nodes, 0 elsewhere, other cells included); its
  /// gradient, taken as a pressure's is, carries the jump. Also sums the weights by which particles
  /// interpolate between the cell's nodes.
  void weigh_colour(const State& state, int c) {
    const auto& list = state.neighbours;
    const int active = state.particles.active_end();
    gradient_x_.assign(active, 0);
    gradient_y_.assign(active, 0);
    weight_.assign(active, 0);
    for (int i = 0; i < active; ++i) {
      const double here = colour(state, c, i);
      double gx = 0, gy = 0, weight = 0;
      bool near = false;
      for (int k = list.begin(i); k < list.end(i); ++k) {
        const int j = list.j[k];
        const double difference = colour(state, c, j) - here;
        if (difference == 0) continue;
        near = true;
        gx += state.operators.pressure_dx(i)[k - list.begin(i)] * difference;
        gy += state.operators.pressure_dy(i)[k - list.begin(i)] * difference;
      }
      if (!near) continue;
      for (int k = list.begin(i); k < list.end(i); ++k) {
        if (of_membrane(state, c, list.j[k])) weight += interpolation(state, list.r[k]);
      }
      if (of_membrane(state, c, i)) weight += interpolation(state, 0);
      gradient_x_[i] = gx;
      gradient_y_[i] = gy;
      weight_[i] = weight;
    }
  }

  void share_out(const State& state, const CellState& cell, int q) {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    const int node = cell.first_node + q;
    const int before = cell.first_node + (q + cell.nodes - 1) % cell.nodes;
    const int after = cell.first_node + (q + 1) % cell.nodes;
    double tx = particles.x[after] - particles.x[before];
    double ty = particles.y[after] - particles.y[before];
    const double chord = std::hypot(tx, ty);
    tx /= chord;
    ty /= chord;
    const double nx = ty, ny = -tx;  // outward, as the ring is counter-clockwise
    const double length =
        0.5 * (std::hypot(particles.x[after] - particles.x[node], particles.y[after] - particles.y[node]) +
               std::hypot(particles.x[before] - particles.x[node], particles.y[before] - particles.y[node]));
    const double jump = state.spacing * state.spacing / length;

    double spread = 1;
    for (int k = list.begin(node); k < list.end(node); ++k) {
      if (list.j[k] < particles.active_end()) spread += tangential(state, list.r[k]);
    }
    const auto give = [&](int i, double r) {
      const double w = tangential(state, r) / spread;
      Share share{i, w * tx * tx, w * tx * ty, w * tx * ty, w * ty * ty};
      if (weight_[i] > 0) {
        const double normal = interpolation(state, r) / weight_[i] * jump;
        share.xx -= gradient_x_[i] * normal * nx;
        share.xy -= gradient_x_[i] * normal * ny;
        share.yx -= gradient_y_[i] * normal * nx;
        share.yy -= gradient_y_[i] * normal * ny;
      } else if (w == 0) {
        return;
      }
      shares_.push_back(share);
    };
    give(node, 0);
    for (int k = list.begin(node); k < list.end(node); ++k) {
      if (list.j[k] < particles.active_end()) give(list.j[k], list.r[k]);
    }
    begin_.push_back(static_cast<int>(shares_.size()));
  }

  static bool of_membrane(const State& state, int c, int i) {
    return i < state.particles.membrane_end() && state.particles.cell[i] == c;
  }

  static double colour(const State& state, int c, int i) {
    if (state.particles.cell[i] != c) return 0;
    return i < state.particles.membrane_end() ? 0.5 : 1.0;
  }

  /// Weight of a node at distance r in the jump that a particle sees.
  static double interpolation(const State& state, double r) {
    const double q2 = 1 - r * r / (state.radius * state.radius);
    return q2 * q2 / (r * r + 0.1 * state.spacing * state.spacing);
  }

  static double tangential(const State& state, double r) {
    const double q = r / (tangential_range * state.spacing);
    return q < 1 ? (1 - q) * (1 - q) * (1 + 2 * q) : 0;
  }

  std::vector<int> begin_{0};
  std::vector<Share> shares_;
  std::vector<double> gradient_x_, gradient_y_, weight_;
  const std::vector<cells::Stiffness>* stiffness_ = nullptr;
  double per_mass_ = 0;
  mutable std::vector<double> node_rate_;
};

}  // namespace

const EffectKind membrane_coupling{
    "membrane_coupling", Stage::forces, false,
    [](const Case& scene) { return needs_cells(scene, "the fluid feels the membranes' forces"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneCoupling>(); }};

}  // namespace rouleau::effects
