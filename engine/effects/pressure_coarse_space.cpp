#include "engine/effects/pressure_coarse_space.h"

#include "engine/linear/aggregates.h"

namespace rouleau::effects {

namespace {

constexpr double width = 5;  // spacings

class PressureCoarseSpace : public Effect {
 public:
  explicit PressureCoarseSpace(const State& state)
      : grid_(width * state.spacing, state.outline.period_x(), state.outline.period_y()) {}

  void apply(State& state) override {
    const auto& particles = state.particles;
    x_.clear();
    y_.clear();
    for (int i = 0; i < state.projection.neighbours.rows(); ++i) {
      if (!state.projection.is_unknown(particles, i)) continue;
      x_.push_back(particles.x[i]);
      y_.push_back(particles.y[i]);
    }
    state.projection.aggregates = grid_.build(x_, y_);
  }

 private:
  linear::GridAggregates grid_;
  std::vector<double> x_, y_;
};

}  // namespace

const EffectKind pressure_coarse_space{
    "pressure_coarse_space",
    Stage::pressure,
    true,
    [](const Case& scene) {
      Need need = of_published_scheme(scene, "");
      if (!need.called_for) return need;
      return Need{
          false,
          "the published scheme solves by plain conjugate gradients; \"on\" gives the same pressure in "
          "a tenth of the iterations",
          "/numerics/preset", true};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<PressureCoarseSpace>(state); },
    "",
    {},
    {.particle = 5}};

}  // namespace rouleau::effects
