#include "engine/effects/contact.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rouleau::effects {

namespace {

// In spacings: how near a wall and another membrane must come, and how many links along the same membrane
// count as its own neighbourhood.
constexpr double wall_range = 0.5;
constexpr double membrane_range = 0.75;
constexpr int own_neighbourhood = 6;
// Acceleration of a node in full contact, in nu U / d0^2: ten times what viscous traction can bring up.
constexpr double strength = 10;

/// The point of a link nearest to a node.
struct Touch {
  double distance = 1e300;
  int a = -1, b = -1;  ///< the link's nodes
  double s = 0;        ///< position along it
  double nx = 0, ny = 0;
};

class Contact : public Effect {
 public:
  void apply(State& state) override {
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      const CellState& cell = state.cells[c];
      for (int q = 0; q < cell.nodes; ++q) {
        push_off_walls(state, cell, cell.first_node + q);
        push_off_membranes(state, cell, cell.first_node + q);
      }
    }
  }

 private:
  static double force(const State& state, const CellState& cell, double closeness) {
    const double acceleration = strength * state.viscosity / (state.spacing * state.spacing);
    return acceleration * closeness * closeness * cell.material.rest_length * state.spacing;
  }

  static void push_off_walls(State& state, const CellState& cell, int node) {
    const auto wall = state.outline.distance(state.particles.x[node], state.particles.y[node]);
    const double closeness = 1 - wall.value / (wall_range * state.spacing);
    if (closeness <= 0) return;
    const double f = force(state, cell, closeness);
    state.load.fx[node] += f * wall.nx;
    state.load.fy[node] += f * wall.ny;
  }

  static void push_off_membranes(State& state, const CellState& cell, int node) {
    const int own = state.particles.cell[node];
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      const Touch touch = nearest_link(state, state.cells[c], node, static_cast<int>(c) == own);
      const double closeness = 1 - touch.distance / (membrane_range * state.spacing);
      if (touch.a < 0 || closeness <= 0) continue;
      const double f = force(state, cell, closeness);
      state.load.fx[node] += f * touch.nx;
      state.load.fy[node] += f * touch.ny;
      state.load.fx[touch.a] -= (1 - touch.s) * f * touch.nx;
      state.load.fy[touch.a] -= (1 - touch.s) * f * touch.ny;
      state.load.fx[touch.b] -= touch.s * f * touch.nx;
      state.load.fy[touch.b] -= touch.s * f * touch.ny;
    }
  }

  /// Among the links at the nodes in the node's neighbour list. The push is along the link's outward normal
  /// off another cell (also when the node is already past it), and away from the point within one's own.
  static Touch nearest_link(const State& state, const CellState& other, int node, bool own) {
    const auto& particles = state.particles;
    Touch touch;
    for (int k = state.neighbours.begin(node); k < state.neighbours.end(node); ++k) {
      const int j = state.neighbours.j[k] - other.first_node;
      if (j < 0 || j >= other.nodes) continue;
      for (const int from : {(j + other.nodes - 1) % other.nodes, j}) {
        const int to = (from + 1) % other.nodes;
        if (own && (ring_distance(from, node - other.first_node, other.nodes) <= own_neighbourhood ||
                    ring_distance(to, node - other.first_node, other.nodes) <= own_neighbourhood)) {
          continue;
        }
        const int a = other.first_node + from;
        const int b = other.first_node + to;
        const double ex = particles.x[b] - particles.x[a], ey = particles.y[b] - particles.y[a];
        const double px = particles.x[node] - particles.x[a], py = particles.y[node] - particles.y[a];
        const double s = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
        const double dx = px - s * ex, dy = py - s * ey;
        const double distance = std::hypot(dx, dy);
        if (distance >= touch.distance) continue;
        const double length = std::hypot(ex, ey);
        touch = {distance, a, b, s, ey / length, -ex / length};
        if (own && distance > 0) {
          touch.nx = dx / distance;
          touch.ny = dy / distance;
        }
      }
    }
    return touch;
  }

  static int ring_distance(int a, int b, int nodes) {
    const int along = std::abs(a - b);
    return std::min(along, nodes - along);
  }
};

}  // namespace

const EffectKind contact{
    "contact",
    Stage::forces,
    true,
    [](const Case& scene) { return needs_cells(scene, "a cell can come near walls and membranes"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Contact>(); },
    has_membranes};

}  // namespace rouleau::effects
