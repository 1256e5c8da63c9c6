#include "engine/effects/membrane_sides.h"

#include "engine/cells/shape.h"
#include "engine/effects/breach.h"

namespace rouleau::effects {

namespace {

constexpr double return_depth = 0.1;  // spacings behind the link

class MembraneSides : public Effect {
 public:
  void apply(State& state) override {
    const auto& particles = state.particles;
    for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
      for (const int c : cells_nearby(state, i)) {
        const bool belongs = particles.cell[i] == c;
        const cells::Ring ring = state.ring(state.cells[c]);
        if (cells::contains(ring, particles.x[i], particles.y[i]) == belongs) continue;
        put_back(state, i, ring, belongs ? -1 : 1);
        if (cells::contains(ring, particles.x[i], particles.y[i]) != belongs) {
          throw breach_at(state, i, {"particles on the wrong side of a membrane", 1, 0});
        }
        ++state.counters.wrong_side;
      }
    }
  }

 private:
  /// Cells with a node among the particle's neighbours: nothing crosses a membrane that it was not near.
  static std::vector<int> cells_nearby(const State& state, int i) {
    const auto& list = state.neighbours;
    std::vector<int> found;
    for (int k = list.begin(i); k < list.end(i); ++k) {
      if (list.j[k] >= state.particles.membrane_end()) continue;
      const int c = state.particles.cell[list.j[k]];
      if (found.empty() || found.back() != c) found.push_back(c);
    }
    return found;
  }

  static void put_back(State& state, int i, cells::Ring ring, double outward) {
    auto& particles = state.particles;
    const cells::Nearest link = cells::nearest(ring, particles.x[i], particles.y[i]);
    particles.x[i] = link.x + outward * return_depth * state.spacing * link.nx;
    particles.y[i] = link.y + outward * return_depth * state.spacing * link.ny;
  }
};

}  // namespace

const EffectKind membrane_sides{
    "membrane_sides",
    Stage::motion,
    false,
    [](const Case& scene) { return needs_cells(scene, "a membrane lets no fluid through"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneSides>(); },
    has_membranes};

}  // namespace rouleau::effects
