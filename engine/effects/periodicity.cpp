#include "engine/effects/periodicity.h"

#include <cmath>

namespace rouleau::effects {

namespace {

void fold(std::vector<double>& positions, int begin, int end, double period) {
  if (period <= 0) return;
  for (int i = begin; i < end; ++i) positions[i] -= period * std::floor(positions[i] / period);
}

class Periodicity : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    fold(particles.x, particles.membrane_end(), particles.active_end(), state.outline.period_x());
    fold(particles.y, particles.membrane_end(), particles.active_end(), state.outline.period_y());
  }
};

}  // namespace

const EffectKind periodicity{
    "periodicity", Stage::boundaries, false,
    [](const Case& scene) {
      const bool periodic = scene.vessel.ends == Ends::periodic;
      return Need{periodic, periodic ? "the vessel repeats itself" : "the vessel does not repeat itself",
                  "/vessel/ends"};
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Periodicity>(); }};

}  // namespace rouleau::effects
