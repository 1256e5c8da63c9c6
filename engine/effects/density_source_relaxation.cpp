#include "engine/effects/density_source_relaxation.h"

namespace rouleau::effects {

namespace {

constexpr double factor = 0.2;

class DensitySourceRelaxation : public Effect {
 public:
  void apply(State& state) override {
    for (double& source : state.projection.source) source *= factor;
  }
};

}  // namespace

const EffectKind density_source_relaxation{
    "density_source_relaxation",
    Stage::pressure,
    true,
    [](const Case& scene) {
      return of_published_scheme(scene,
                                 "change to the published scheme: a fifth of eq. 7, since all of it swings "
                                 "from step to step and diverges");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<DensitySourceRelaxation>(); },
    "",
    {},
    {.particle = 0.2}};

}  // namespace rouleau::effects
