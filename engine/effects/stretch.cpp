#include "engine/effects/stretch.h"

#include "engine/cells/stretch.h"

namespace rouleau::effects {

namespace {

class Stretch : public Effect {
 public:
  void apply(State& state) override {
    for (const CellState& cell : state.cells) {
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      cells::add_stretch_forces(state.ring(cell), cell.material, {&state.load.fx[cell.first_node], nodes},
                                {&state.load.fy[cell.first_node], nodes});
      cells::append_stretch_stiffness(state.ring(cell), cell.material, cell.first_node, state.load.stiffness);
    }
  }
};

}  // namespace

const EffectKind stretch{
    "stretch", Stage::forces, true,
    [](const Case& scene) { return needs_cells(scene, "a cell's membrane resists being stretched"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Stretch>(); }};

}  // namespace rouleau::effects
