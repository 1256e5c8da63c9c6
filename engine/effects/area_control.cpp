#include "engine/effects/area_control.h"

#include <algorithm>

#include "engine/cells/ring.h"

namespace rouleau::effects {

namespace {

// Time over which a drift of area is undone, in diameters over inflow velocities; never under two steps.
constexpr double relaxation_time = 0.01;

class AreaControl : public Effect {
 public:
  void apply(State& state) override {
    const double time = std::max(relaxation_time, 2 * state.dt);
    std::vector<double> wanted;
    for (const CellState& cell : state.cells) {
      // The drift of a cell that fades is not undone by flow out of the vessel.
      const double drift = cell.departure ? 0 : 1 - cells::area(state.ring(cell)) / cell.start_area;
      wanted.push_back(cell.presence * drift / time + cell.area_rate);
    }
    for (int i = state.particles.membrane_end(); i < state.particles.active_end(); ++i) {
      if (state.particles.cell[i] >= 0) state.source[i] += wanted[state.particles.cell[i]];
    }
  }
};

}  // namespace

const EffectKind area_control{
    "area_control",
    Stage::pressure,
    true,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "a cell keeps its volume"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<AreaControl>(); },
    has_membranes};

}  // namespace rouleau::effects
