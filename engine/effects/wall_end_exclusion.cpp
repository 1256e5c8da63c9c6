#include "engine/effects/wall_end_exclusion.h"

namespace rouleau::effects {

namespace {

// Of the lattice's number density: the usual bound below which MPS takes a particle for one of a free
// surface.
constexpr double least_density = 0.97;

class WallEndExclusion : public Effect {
 public:
  void apply(State& state) override {
    DensityProjection& projection = state.projection;
    const auto& list = projection.neighbours;
    const double least = least_density * projection.mps.density();
    for (int i = state.particles.pressure_end(); i < list.rows(); ++i) {
      projection.has_pressure[i] = projection.density[i] >= least;
    }
    for (int k = 0; k < list.pairs(); ++k) {
      if (!projection.has_pressure[list.j[k]]) projection.weights.pair[k] = 0;
    }
  }
};

}  // namespace

const EffectKind wall_end_exclusion{
    "wall_end_exclusion",
    Stage::pressure,
    true,
    [](const Case& scene) {
      return of_published_scheme(scene,
                                 "change to the published scheme: ends of walls and of the inlet have no "
                                 "pressure, since their neighbourhoods are cut off");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<WallEndExclusion>(); },
    "",
    {},
    {.particle = 12.7}};

}  // namespace rouleau::effects
