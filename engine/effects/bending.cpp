#include "engine/effects/bending.h"

#include "engine/cells/bending.h"

namespace rouleau::effects {

namespace {

class Bending : public Effect {
 public:
  void apply(State& state) override {
    for (const CellState& cell : state.cells) {
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      cells::add_bending_forces(state.ring(cell), cell.material, {&state.load.fx[cell.first_node], nodes},
                                {&state.load.fy[cell.first_node], nodes});
      cells::append_bending_stiffness(state.ring(cell), cell.material, cell.first_node, state.load.stiffness);
    }
  }
};

}  // namespace

const EffectKind bending{
    "bending", Stage::forces, true,
    [](const Case& scene) { return needs_cells(scene, "a cell's membrane resists bending"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Bending>(); }};

}  // namespace rouleau::effects
