#include "engine/effects/gradient_from_least_pressure.h"

#include <algorithm>

namespace rouleau::effects {

namespace {

class GradientFromLeastPressure : public Effect {
 public:
  void apply(State& state) override {
    DensityProjection& projection = state.projection;
    const auto& list = projection.neighbours;
    const auto& p = state.particles.p;
    for (int i = 0; i < state.particles.active_end(); ++i) {
      double least = p[i];
      for (int k = list.begin(i); k < list.end(i); ++k) {
        if (projection.has_pressure[list.j[k]]) least = std::min(least, p[list.j[k]]);
      }
      projection.base[i] = least;
    }
  }
};

}  // namespace

const EffectKind gradient_from_least_pressure{
    "gradient_from_least_pressure",
    Stage::pressure,
    true,
    [](const Case& scene) {
      return of_published_scheme(scene,
                                 "change to the published scheme: eq. 5 against the least pressure nearby "
                                 "instead of p_i, so that particles push each other apart and never pull");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<GradientFromLeastPressure>(); },
    "",
    {},
    {.particle = 9}};

}  // namespace rouleau::effects
