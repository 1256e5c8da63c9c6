#include "engine/effects/neighbours.h"

namespace rouleau::effects {

namespace {

class Neighbours : public Effect {
 public:
  void apply(State& state) override {
    state.neighbours.sort(state.particles);
    state.neighbours.build(state.particles);
    const auto active = static_cast<std::size_t>(state.particles.active_end());
    for (auto* field : {&state.ax, &state.ay, &state.source, &state.divergence, &state.pressure_gx,
                        &state.pressure_gy, &state.shift_x, &state.shift_y}) {
      field->assign(active, 0);
    }
    const auto nodes = static_cast<std::size_t>(state.particles.membrane_end());
    state.load.fx.assign(nodes, 0);
    state.load.fy.assign(nodes, 0);
    state.load.stiffness.clear();
    state.implicit_forces.clear();
    state.viscosity_factor.clear();
  }
};

}  // namespace

const EffectKind neighbours{
    "neighbours",
    Stage::operators,
    false,
    [](const Case&) { return always("particles feel those within the kernel's radius"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Neighbours>(); },
    "",
    {},
    {.particle = 170}};

}  // namespace rouleau::effects
