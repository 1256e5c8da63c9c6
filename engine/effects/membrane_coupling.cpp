#include "engine/effects/membrane_coupling.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/neighbourhood.h"

namespace rouleau::effects {

namespace {

constexpr double tangential_range = 1.6;  // spacings
constexpr double most_scaling = 3;        // of a node's normal force, up or down

/// Share of one node's force that one particle receives: an acceleration per acceleration of the node.
struct Share {
  int particle;
  double xx, xy, yx, yy;
};

/// The gradient of a cell's colour at a particle.
struct ColourGradient {
  int particle;
  double x, y;
};

/// Outward normal of a membrane node, and its length: together the gradient of the enclosed area by the
/// node's position, so that what a pressure does to the nodes is a jump exactly.
struct Facet {
  double nx, ny, length;
};

/// Hands forces of nodes to the fluid, linearly. Of each cell's normal force the mean, a pressure jump, is
/// carried by the gradient of its colour, taken as a pressure's is: so a jump at rest is balanced exactly.
/// What differs from the mean is shared out so that the fluid gets what the node gives. Rebuilt every step,
/// and applied to the forces as they are and, as an implicit force, to what the membranes' stiffness makes of
/// the velocities.
class MembraneCoupling : public CellEffect, public ImplicitForce {
 public:
  void apply(State& state) override {
    build(state);
    per_mass_ = 1 / (state.spacing * state.spacing);
    stiffness_ = &state.load.stiffness;
    node_rate_.resize(2 * facets_.size());
    for (std::size_t node = 0; node < facets_.size(); ++node) {
      node_rate_[2 * node] = state.load.fx[node] * per_mass_;
      node_rate_[2 * node + 1] = state.load.fy[node] * per_mass_;
    }
    hand_over([&](int i, double x, double y) {
      state.ax[i] += x;
      state.ay[i] += y;
    });
    state.implicit_forces.push_back(this);
  }

  void add_response(const double* velocity, double time, double* acceleration) const override {
    add_response_of(velocity, time, acceleration);
  }
  void add_response(const float* velocity, double time, float* acceleration) const override {
    add_response_of(velocity, time, acceleration);
  }

 private:
  template <class Real>
  void add_response_of(const Real* velocity, double time, Real* acceleration) const {
    node_rate_.assign(2 * facets_.size(), 0);
    for (const cells::Stiffness& element : *stiffness_) {
      double along = 0;
      for (int q = 0; q < 3; ++q) {
        along += element.g[2 * q] * velocity[2 * element.node[q]] +
                 element.g[2 * q + 1] * velocity[2 * element.node[q] + 1];
      }
      along *= -element.k * per_mass_ * time;
      for (int q = 0; q < 3; ++q) {
        node_rate_[2 * element.node[q]] += along * element.g[2 * q];
        node_rate_[2 * element.node[q] + 1] += along * element.g[2 * q + 1];
      }
    }
    hand_over([&](int i, double x, double y) {
      acceleration[2 * i] += static_cast<Real>(x);
      acceleration[2 * i + 1] += static_cast<Real>(y);
    });
  }

  /// Takes the accelerations of the nodes out of node_rate_.
  template <class Add>
  void hand_over(const Add& add) const {
    for (const CellRange& cell : cells_) {
      double normal = 0, perimeter = 0;
      for (int node = cell.first_node; node < cell.end_node; ++node) {
        const Facet& facet = facets_[node];
        normal += node_rate_[2 * node] * facet.nx + node_rate_[2 * node + 1] * facet.ny;
        perimeter += facet.length;
      }
      const double jump = normal / (perimeter * per_mass_);
      for (int k = cell.first_gradient; k < cell.end_gradient; ++k) {
        add(gradients_[k].particle, -jump * gradients_[k].x, -jump * gradients_[k].y);
      }
      for (int node = cell.first_node; node < cell.end_node; ++node) {
        const Facet& facet = facets_[node];
        const double mean = jump * facet.length * per_mass_;
        const double ax = node_rate_[2 * node] - mean * facet.nx;
        const double ay = node_rate_[2 * node + 1] - mean * facet.ny;
        for (int k = begin_[node]; k < begin_[node + 1]; ++k) {
          const Share& share = shares_[k];
          add(share.particle, share.xx * ax + share.xy * ay, share.yx * ax + share.yy * ay);
        }
      }
    }
  }

  struct CellRange {
    int first_node, end_node;
    int first_gradient, end_gradient;
  };

  void build(const State& state) {
    begin_.assign(1, 0);
    shares_.clear();
    gradients_.clear();
    facets_.clear();
    cells_.clear();
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      if (state.cells[c].departure) continue;
      const CellState& cell = state.cells[c];
      const auto first_gradient = static_cast<int>(gradients_.size());
      weigh_colour(state, static_cast<int>(c));
      for (int q = 0; q < cell.nodes; ++q) share_out(state, cell, q);
      cells_.push_back({cell.first_node, cell.first_node + cell.nodes, first_gradient,
                        static_cast<int>(gradients_.size())});
    }
  }

  /// Each cell has its own colour (1 inside it, 1/2 on its nodes, 0 elsewhere, other cells included); its
  /// gradient, taken as a pressure's is, carries the jump. Also sums the weights by which particles
  /// interpolate between the cell's nodes.
  void weigh_colour(const State& state, int c) {
    const auto& list = state.neighbours;
    const CellState& cell = state.cells[c];
    // What has a neighbour across a membrane has one beside a node of it.
    constexpr int hops = 2;
    const auto& near_cell = neighbourhood_.around(state, nodes_of(cell), hops);
    for (auto* field : {&gradient_x_, &gradient_y_, &weight_}) {
      field->resize(static_cast<std::size_t>(state.particles.active_end()));
      for (const int i : near_cell) (*field)[i] = 0;
    }
    for (const int i : near_cell) {
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
      gradients_.push_back({i, gx, gy});
    }
  }

  void share_out(const State& state, const CellState& cell, int q) {
    const auto& particles = state.particles;
    const int node = cell.first_node + q;
    const int before = cell.first_node + (q + cell.nodes - 1) % cell.nodes;
    const int after = cell.first_node + (q + 1) % cell.nodes;
    double tx = particles.x[after] - particles.x[before];
    double ty = particles.y[after] - particles.y[before];
    const double chord = std::hypot(tx, ty);
    tx /= chord;
    ty /= chord;
    const double nx = ty, ny = -tx;  // outward, as the ring is counter-clockwise
    const double length = chord / 2;
    facets_.push_back({nx, ny, length});
    const double jump = state.spacing * state.spacing / length;

    // What another membrane encloses, and that membrane, are not dragged along.
    const auto spread_weight = [&](int i, double r) {
      return particles.cell[i] < 0 || particles.cell[i] == particles.cell[node] ? tangential(state, r) : 0;
    };
    double spread = 0;
    double received_x = 0, received_y = 0;  // of a unit normal force
    const auto weigh = [&](int i, double r) {
      spread += spread_weight(i, r);
      if (weight_[i] == 0) return;
      const double normal = of_this_sheet(i, nx, ny) * interpolation(state, r) / weight_[i] * jump;
      received_x -= gradient_x_[i] * normal;
      received_y -= gradient_y_[i] * normal;
    };
    for_each_receiver(state, node, weigh);
    const double along = received_x * nx + received_y * ny, aside = received_x * tx + received_y * ty;
    const double scale = 1 / std::clamp(along, 1 / most_scaling, most_scaling);
    // What goes astray along the membrane is taken back by the tangential part.
    const double kx = tx - scale * aside * nx, ky = ty - scale * aside * ny;
    const auto give = [&](int i, double r) {
      const double w = spread_weight(i, r) / spread;
      Share share{i, w * tx * kx, w * tx * ky, w * ty * kx, w * ty * ky};
      if (weight_[i] > 0) {
        const double normal = scale * of_this_sheet(i, nx, ny) * interpolation(state, r) / weight_[i] * jump;
        share.xx -= gradient_x_[i] * normal * nx;
        share.xy -= gradient_x_[i] * normal * ny;
        share.yx -= gradient_y_[i] * normal * nx;
        share.yy -= gradient_y_[i] * normal * ny;
      } else if (w == 0) {
        return;
      }
      shares_.push_back(share);
    };
    for_each_receiver(state, node, give);
    begin_.push_back(static_cast<int>(shares_.size()));
  }

  /// The node itself and the active particles around it, each with its distance.
  template <class Use>
  static void for_each_receiver(const State& state, int node, const Use& use) {
    const auto& list = state.neighbours;
    use(node, 0.0);
    for (int k = list.begin(node); k < list.end(node); ++k) {
      if (list.j[k] < state.particles.active_end()) use(list.j[k], static_cast<double>(list.r[k]));
    }
  }

  static bool of_membrane(const State& state, int c, int i) {
    return i < state.particles.membrane_end() && state.particles.cell[i] == c;
  }

  static double colour(const State& state, int c, int i) {
    if (state.particles.cell[i] != c) return 0;
    return i < state.particles.membrane_end() ? 0.5 : 1.0;
  }

  /// Where a cell is pinched, a node's neighbours belong to the opposite sheet, too: there the colour rises
  /// the other way, and they would receive its normal force reversed. 1 up to 60 degrees from the normal, 0
  /// from 90 on.
  double of_this_sheet(int i, double nx, double ny) const {
    const double inwards = -(gradient_x_[i] * nx + gradient_y_[i] * ny);
    const double size = std::hypot(gradient_x_[i], gradient_y_[i]);
    return size > 0 ? std::clamp(2 * inwards / size, 0.0, 1.0) : 0;
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

  std::vector<CellRange> cells_;
  std::vector<Facet> facets_;  ///< [membrane nodes]
  std::vector<ColourGradient> gradients_;
  std::vector<int> begin_{0};
  std::vector<Share> shares_;
  std::vector<double> gradient_x_, gradient_y_, weight_;  ///< [particles], valid around the present cell
  Neighbourhood neighbourhood_;
  const std::vector<cells::Stiffness>* stiffness_ = nullptr;
  double per_mass_ = 0;
  mutable std::vector<double> node_rate_;
};

}  // namespace

const EffectKind membrane_coupling{
    "membrane_coupling",
    Stage::forces,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "the fluid feels the membranes' forces"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneCoupling>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 4300}};

}  // namespace rouleau::effects
