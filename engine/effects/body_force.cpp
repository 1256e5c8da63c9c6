#include "engine/effects/body_force.h"

namespace rouleau::effects {

namespace {

class BodyForce : public Effect {
 public:
  explicit BodyForce(const State& state)
      : ax_(state.scene.body_acceleration[0] / state.scales.acceleration()),
        ay_(state.scene.body_acceleration[1] / state.scales.acceleration()) {}

  void apply(State& state) override {
    for (double& a : state.ax) a += ax_;
    for (double& a : state.ay) a += ay_;
  }

 private:
  double ax_, ay_;
};

}  // namespace

const EffectKind body_force{
    "body_force",
    Stage::forces,
    false,
    [](const Case& scene) {
      const auto& a = scene.body_acceleration;
      const bool given = a[0] != 0 || a[1] != 0;
      return Need{given, given ? "the case accelerates the plasma" : "nothing accelerates the plasma",
                  "/body_acceleration"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<BodyForce>(state); },
    "",
    {},
    {.particle = 0.6}};

}  // namespace rouleau::effects
