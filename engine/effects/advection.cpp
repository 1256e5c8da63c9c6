#include "engine/effects/advection.h"

namespace rouleau::effects {

namespace {

class Advection : public Effect {
 public:
  void apply(State& state) override {
    const auto& particles = state.particles;
    state.next_x = particles.x;
    state.next_y = particles.y;
    for (int i = 0; i < particles.inlet_end(); ++i) {
      state.next_x[i] += state.dt * particles.u[i];
      state.next_y[i] += state.dt * particles.v[i];
    }
  }
};

}  // namespace

const EffectKind advection{"advection", Stage::motion, false,
                           [](const Case&) { return always("particles move with the flow"); },
                           [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Advection>(); }};

}  // namespace rouleau::effects
