#include "engine/effects/inextensible.h"

#include <string>
#include <utility>

#include "engine/cells/inextensible.h"

namespace rouleau::effects {

namespace {

// Tension per strain in the viscous step, times the step, over viscosity and spacing: ten times as much takes
// the solver twice as long and gains nothing.
constexpr double stiffness = 100;
// By what part of that the tension follows. The pressure answers to it a step later, so that with all of it
// tension and pressure take turns growing.
constexpr double share = 0.2;

class Inextensible : public CellEffect {
 public:
  void apply(State& state) override {
    const double viscous = stiffness * state.viscosity * state.spacing, modulus = viscous / state.dt;
    for (CellState& cell : state.cells) {
      if (cell.departure) continue;
      const cells::Ring ring = state.ring(cell);
      if (cell.held.length.empty()) hold(cell, ring);
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      // Before an outlet a membrane fades: it holds nothing any more.
      if (cell.presence == 1) {
        cells::update_tension(ring, {&state.particles.u[cell.first_node], nodes},
                              {&state.particles.v[cell.first_node], nodes}, share * viscous, cell.held);
      }
      cells::add_held_forces(ring, cell.held, modulus, {&state.load.fx[cell.first_node], nodes},
                             {&state.load.fy[cell.first_node], nodes});
      cells::append_held_stiffness(ring, cell.held, modulus, cell.first_node, state.load.stiffness);
    }
  }

 private:
  /// Nodes that were placed anew begin with the tension that was there.
  static void hold(CellState& cell, cells::Ring ring) {
    cells::HeldLinks held = cells::hold_links(ring, cell.material);
    if (!cell.held.tension.empty()) held.tension = cell.held.tension;
    cell.held = std::move(held);
  }
};

}  // namespace

const EffectKind inextensible{
    "inextensible",
    Stage::forces,
    true,
    [](const Case& scene) {
      for (std::size_t k = 0; k < scene.cells.size(); ++k) {
        if (deflates(scene.cells[k]))
          return Need{false, "a circle whose membrane keeps its length cannot deflate",
                      "/cells/" + std::to_string(k) + "/shape"};
      }
      return on_request(of_accurate_scheme(scene, needs_cells(scene, "membranes stretch")),
                        "membranes stretch unless the case makes them inextensible");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Inextensible>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 40}};

}  // namespace rouleau::effects
