#include "engine/effects/fading.h"

#include <algorithm>

namespace rouleau::effects {

namespace {

class Fading : public Effect {
 public:
  bool awake(const State& state) override {
    return std::any_of(state.cells.begin(), state.cells.end(),
                       [](const CellState& cell) { return !cell.departure && cell.presence < 1; });
  }

  void apply(State& state) override {
    const auto presence = [&](int node) { return state.cells[state.particles.cell[node]].presence; };
    for (int node = 0; node < state.particles.membrane_end(); ++node) {
      state.load.fx[node] *= presence(node);
      state.load.fy[node] *= presence(node);
    }
    for (cells::Stiffness& element : state.load.stiffness) element.k *= presence(element.node[0]);
  }
};

}  // namespace

const EffectKind fading{"fading",
                        Stage::forces,
                        false,
                        [](const Case& scene) {
                          return needs_cells_that_leave(scene, "a membrane's forces fade before an outlet");
                        },
                        [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Fading>(); },
                        "while no cell is near an outlet",
                        {},
                        {.membrane_node = 2}};

}  // namespace rouleau::effects
