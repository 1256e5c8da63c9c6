#include "engine/effects/membrane_clearance.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/neighbourhood.h"

namespace rouleau::effects {

namespace {

constexpr double clearance = 0.4;      // spacings
constexpr double longest_push = 0.05;  // spacings a step
constexpr double lost = 0.8;           // farther through than this, it is not this effect's to mend

class MembraneClearance : public CellEffect {
 public:
  void apply(State& state) override {
    for (const int i : neighbourhood_.around(state, membrane_nodes(state))) {
      if (i < state.particles.membrane_end()) continue;
      const Side side = nearest_link(state, i);
      const double d0 = state.spacing;
      if (side.distance >= clearance * d0 || side.distance <= -lost * d0) continue;
      const double push = std::min(0.5 * (clearance * d0 - side.distance), longest_push * d0);
      state.shift_x[i] += push * side.nx;
      state.shift_y[i] += push * side.ny;
    }
  }

 private:
  /// Distance to the nearest link, negative once the particle is through it, and the way back.
  struct Side {
    double distance = 1e300;
    double nx = 0, ny = 0;
  };

  static Side nearest_link(const State& state, int i) {
    const auto& list = state.neighbours;
    const double x = state.next_x[i] + state.shift_x[i];
    const double y = state.next_y[i] + state.shift_y[i];
    double best = 1e300;
    Side side;
    for (int k = list.begin(i); k < list.end(i); ++k) {
      const int node = list.j[k];
      if (node >= state.particles.membrane_end()) continue;
      const CellState& cell = state.cells[state.particles.cell[node]];
      const int q = node - cell.first_node;
      for (const int from : {(q + cell.nodes - 1) % cell.nodes, q}) {
        const int a = cell.first_node + from;
        const int b = cell.first_node + (from + 1) % cell.nodes;
        const double ex = state.next_x[b] - state.next_x[a], ey = state.next_y[b] - state.next_y[a];
        double px = x - state.next_x[a], py = y - state.next_y[a];
        px -= state.periods_x(px);
        py -= state.periods_y(py);
        const double s = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
        const double dx = px - s * ex, dy = py - s * ey;
        const double distance = std::hypot(dx, dy);
        if (distance >= best) continue;
        best = distance;
        const double length = std::hypot(ex, ey);
        const double outward = state.particles.cell[i] == state.particles.cell[node] ? -1 : 1;
        side.nx = outward * ey / length;
        side.ny = -outward * ex / length;
        side.distance = dx * side.nx + dy * side.ny;
      }
    }
    return side;
  }

  Neighbourhood neighbourhood_;
};

}  // namespace

const EffectKind membrane_clearance{
    "membrane_clearance",
    Stage::motion,
    true,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "fluid must not crowd onto a membrane"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneClearance>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 2300}};

}  // namespace rouleau::effects
