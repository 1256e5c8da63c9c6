#include "engine/effects/membrane_sides.h"

#include "engine/cells/shape.h"
#include "engine/effects/breach.h"
#include "engine/effects/neighbourhood.h"

namespace rouleau::effects {

namespace {

// Spacings behind the link, the next where the cell is too thin for the one before.
constexpr double return_depths[] = {0.1, 0.02, 0.004};

class MembraneSides : public CellEffect {
 public:
  void apply(State& state) override {
    const auto& particles = state.particles;
    for (const int i : neighbourhood_.around(state, membrane_nodes(state))) {
      if (i < particles.membrane_end()) continue;
      find_nodes(state, i);
      for (const int node : nodes_) {
        const int c = particles.cell[node];
        const bool belongs = particles.cell[i] == c;
        const cells::Ring ring = state.ring(state.cells[c]);
        // Where the cell is the particle is looked for, too.
        const double away_x = state.periods_x(particles.x[i] - particles.x[node]);
        const double away_y = state.periods_y(particles.y[i] - particles.y[node]);
        const double x = particles.x[i] - away_x, y = particles.y[i] - away_y;
        if (cells::contains(ring, x, y) == belongs) continue;
        const cells::Nearest link = cells::nearest(ring, x, y);
        bool returned = false;
        for (const double depth : return_depths) {
          const double behind = (belongs ? -1 : 1) * depth * state.spacing;
          const double back_x = link.x + behind * link.nx, back_y = link.y + behind * link.ny;
          returned = cells::contains(ring, back_x, back_y) == belongs;
          if (!returned) continue;
          state.particles.x[i] = back_x + away_x;
          state.particles.y[i] = back_y + away_y;
          break;
        }
        if (!returned) throw breach_at(state, i, {"particles on the wrong side of a membrane", 1, 0});
        ++state.counters.wrong_side;
      }
    }
  }

 private:
  /// One node of each cell that has some among the particle's neighbours: nothing crosses a membrane that it
  /// was not near.
  void find_nodes(const State& state, int i) {
    const auto& list = state.neighbours;
    nodes_.clear();
    for (int k = list.begin(i); k < list.end(i); ++k) {
      const int node = list.j[k];
      if (node >= state.particles.membrane_end()) continue;
      const auto& cell = state.particles.cell;
      if (nodes_.empty() || cell[nodes_.back()] != cell[node]) nodes_.push_back(node);
    }
  }

  Neighbourhood neighbourhood_;
  std::vector<int> nodes_;
};

}  // namespace

const EffectKind membrane_sides{
    "membrane_sides",
    Stage::motion,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "a membrane lets no fluid through"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneSides>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 1150}};

}  // namespace rouleau::effects
