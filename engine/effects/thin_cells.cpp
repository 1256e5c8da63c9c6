#include "engine/effects/thin_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/cells/resample.h"
#include "engine/cells/shape.h"
#include "engine/effects/breach.h"

namespace rouleau::effects {

namespace {

constexpr double least = 1.6;  // mean thickness in spacings: fluid leaks from here on
// Longest and shortest link, in spacings. The nodes that a cell starts with may crowd further: their links
// are stiff below 0.8 l0.
constexpr double most_stretched = 1.8, most_crowded = 0.4;

class ThinCells : public CellEffect {
 public:
  void apply(State& state) override {
    state.wanted_spacing = 0;
    for (std::size_t k = 0; k < state.cells.size(); ++k) {
      if (state.cells[k].departure) continue;
      const cells::Ring ring = state.ring(state.cells[k]);
      const double thickness = 2 * cells::area(ring) / cells::perimeter(ring);
      // A membrane that fades before an outlet holds nothing that a film of particles would have to carry.
      const bool carried = state.cells[k].presence == 1;
      const bool thin = carried && thickness < seen_coming * state.spacing;
      const double finer = thin ? finer_spacing(state, thickness) : state.spacing;
      const bool refine = state.scene.numerics.refine == Refine::automatic && finer < 0.99 * state.spacing;
      if (carried && thickness < least * state.spacing && !refine)
        throw too_thin(state, static_cast<int>(k), thickness);
      if (!refine && !uneven(state, state.cells[k], ring)) continue;
      state.wanted_spacing =
          std::min(refine ? finer : state.spacing, state.wanted_spacing > 0 ? state.wanted_spacing : 1e300);
      state.thinnest_cell = static_cast<int>(k);
    }
  }

 private:
  /// Whether the membrane has stretched its nodes so far apart that fluid could pass between them, or swept
  /// those that were placed anew together.
  static bool uneven(const State& state, const CellState& cell, cells::Ring ring) {
    const auto lengths = cells::link_lengths(ring);
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    const bool placed_anew = !cell.material.rest_lengths.empty();
    return *longest > most_stretched * state.spacing ||
           (placed_anew && *shortest < most_crowded * state.spacing);
  }

  /// A whole number of spacings makes the height.
  static double finer_spacing(const State& state, double thickness) {
    const double wanted = std::max(thickness / restored, state.start_spacing / most_refinement);
    return state.outline.height() / std::ceil(state.outline.height() / wanted - 1e-9);
  }

  static SimulationError too_thin(const State& state, int k, double thickness) {
    const cells::Shape shape = cells::measure(state.ring(state.cells[k]));
    const double unit = state.scales.length;
    char advice[80];
    std::snprintf(advice, sizeof advice, "a spacing of %.2g um would do", thickness / restored * unit * 1e6);
    return breach_of_cell(
        state, k, shape.x, shape.y,
        {"mean thickness of a cell", thickness * unit, least * state.spacing * unit, "m", false, advice});
  }
};

}  // namespace

const EffectKind thin_cells{
    "thin_cells",
    Stage::checks,
    false,
    [](const Case& scene) {
      Need need = of_accurate_scheme(
          scene,
          needs_cells(scene, scene.numerics.refine == Refine::automatic
                                 ? "a cell squeezed thinner than two spacings is computed with finer ones"
                                 : "a cell squeezed thinner than two spacings ends the run"));
      if (need.called_for) need.pointer = "/numerics/refine";
      return need;
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ThinCells>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 36}};

}  // namespace rouleau::effects
