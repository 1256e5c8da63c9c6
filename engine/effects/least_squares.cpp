#include "engine/effects/least_squares.h"

namespace rouleau::effects {

namespace {

class LeastSquares : public Effect {
 public:
  void apply(State& state) override { state.operators.build(state.particles, state.neighbours); }
};

}  // namespace

const EffectKind least_squares{
    "least_squares",
    Stage::operators,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, always("derivatives must be exact for quadratic fields"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<LeastSquares>(); },
    "",
    {},
    {.particle = 141, .wall_node = 46}};

}  // namespace rouleau::effects
