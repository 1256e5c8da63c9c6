#include "engine/effects/area_control.h"

#include <algorithm>

#include "engine/cells/offset.h"
#include "engine/cells/ring.h"

namespace rouleau::effects {

namespace {

// Time over which a drift of area is undone, in diameters over inflow velocities; never under two steps.
constexpr double relaxation_time = 0.01;
// Farther than this, in spacings, no step moves a membrane: it has fluid on both sides.
constexpr double longest_move = 0.01;

class AreaControl : public CellEffect {
 public:
  void apply(State& state) override {
    const double share = state.dt / std::max(relaxation_time, 2 * state.dt);
    const double most = longest_move * state.spacing;
    for (const CellState& cell : state.cells) {
      if (cell.departure) continue;
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      const cells::Ring ring{{state.next_x.data() + cell.first_node, nodes},
                             {state.next_y.data() + cell.first_node, nodes}};
      const double lacking = cell.start_area - cells::area(ring);
      const double way = cell.presence * share * lacking / cells::perimeter(ring);
      cells::offset(ring, std::clamp(way, -most, most), moved_x_, moved_y_);
      std::copy(moved_x_.begin(), moved_x_.end(), state.next_x.begin() + cell.first_node);
      std::copy(moved_y_.begin(), moved_y_.end(), state.next_y.begin() + cell.first_node);
    }
  }

 private:
  std::vector<double> moved_x_, moved_y_;
};

}  // namespace

const EffectKind area_control{
    "area_control",
    Stage::motion,
    true,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "a cell keeps its volume"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<AreaControl>(); },
    CellEffect::rests,
    {},
    {.once = 440, .membrane_node = 20}};

}  // namespace rouleau::effects
