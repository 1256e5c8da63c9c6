#include "engine/effects/velocity_correction.h"

namespace rouleau::effects {

namespace {

class VelocityCorrection : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    const DensityProjection& projection = state.projection;
    for (int i = 0; i < particles.active_end(); ++i) {
      const operators::Gradient gp =
          operators::gradient(projection.mps, projection.neighbours, projection.weights, i,
                              particles.p.data(), projection.base[i]);
      particles.u[i] -= state.dt * gp.x;
      particles.v[i] -= state.dt * gp.y;
    }
    for (int i = 0; i < particles.active_end(); ++i) {
      state.divergence[i] = operators::divergence(projection.mps, projection.neighbours, projection.weights,
                                                  i, particles.u.data(), particles.v.data());
    }
  }
};

}  // namespace

const EffectKind velocity_correction{
    "velocity_correction",
    Stage::pressure,
    false,
    [](const Case& scene) { return of_published_scheme(scene, "pressure drives the plasma: eqs. 3 and 5"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<VelocityCorrection>(); },
    "",
    {},
    {.particle = 39}};

}  // namespace rouleau::effects
