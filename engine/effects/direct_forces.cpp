#include "engine/effects/direct_forces.h"

namespace rouleau::effects {

namespace {

class DirectForces : public CellEffect {
 public:
  void apply(State& state) override {
    const double per_mass = 1 / (state.spacing * state.spacing);
    for (int node = 0; node < state.particles.membrane_end(); ++node) {
      state.ax[node] += per_mass * state.load.fx[node];
      state.ay[node] += per_mass * state.load.fy[node];
    }
  }
};

}  // namespace

const EffectKind direct_forces{
    "direct_forces",
    Stage::forces,
    false,
    [](const Case& scene) {
      return of_published_scheme(scene, needs_cells(scene,
                                                    "the springs accelerate the membranes' nodes: "
                                                    "eq. 13"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<DirectForces>(); },
    CellEffect::rests,
    {},
    {.particle = 0.1}};

}  // namespace rouleau::effects
