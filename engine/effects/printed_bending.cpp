#include "engine/effects/printed_bending.h"

#include "engine/cells/bending.h"

namespace rouleau::effects {

namespace {

class PrintedBending : public CellEffect {
 public:
  void apply(State& state) override {
    for (const CellState& cell : state.cells) {
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      cells::add_printed_bending_forces(state.ring(cell), cell.material,
                                        {&state.load.fx[cell.first_node], nodes},
                                        {&state.load.fy[cell.first_node], nodes});
    }
  }
};

}  // namespace

const EffectKind printed_bending{
    "printed_bending",
    Stage::forces,
    true,
    [](const Case& scene) {
      return of_published_scheme(scene,
                                 needs_cells(scene, "a cell's membrane resists bending: eq. 11 as printed"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<PrintedBending>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 114}};

}  // namespace rouleau::effects
