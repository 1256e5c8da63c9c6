#include "engine/effects/particle_motion.h"

namespace rouleau::effects {

namespace {

class ParticleMotion : public Effect {
 public:
  void apply(State& state) override {
    state.particles.x = state.next_x;
    state.particles.y = state.next_y;
  }
};

}  // namespace

const EffectKind particle_motion{
    "particle_motion",
    Stage::motion,
    false,
    [](const Case& scene) {
      return of_published_scheme(scene, "particles carry velocity and pressure along");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ParticleMotion>(); },
    "",
    {},
    {.particle = 0.5}};

}  // namespace rouleau::effects
