#include "engine/effects/advection.h"

namespace rouleau::effects {

namespace {

class Advection : public Effect {
 public:
  void apply(State& state) override {
    const auto& particles = state.particles;
    state.next_x = particles.x;
    state.next_y = particles.y;
    // The velocity half a step ahead, by the change in the last step.
    const double ahead =
        state.last_dt > 0 && !has_membranes(state) && state.scene.numerics.preset != Preset::paper
            ? 0.5 * state.dt / state.last_dt
            : 0;
    const int active = particles.active_end();
    for (int i = 0; i < particles.inlet_end(); ++i) {
      const double half = i < active ? ahead : 0;
      state.next_x[i] += state.dt * (particles.u[i] + half * particles.du[i]);
      state.next_y[i] += state.dt * (particles.v[i] + half * particles.dv[i]);
    }
  }
};

}  // namespace

const EffectKind advection{"advection",
                           Stage::motion,
                           false,
                           [](const Case&) { return always("particles move with the flow"); },
                           [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Advection>(); },
                           "",
                           {},
                           {.particle = 2.9}};

}  // namespace rouleau::effects
