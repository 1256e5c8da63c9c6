#include "engine/effects/wall_clearance.h"

namespace rouleau::effects {

namespace {

constexpr double clearance = 0.4;  // spacings

class WallClearance : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    const double least = clearance * state.spacing;
    for (int i = 0; i < particles.active_end(); ++i) {
      const auto wall = state.outline.distance(particles.x[i], particles.y[i]);
      const double floor = i < particles.membrane_end() ? 0 : least;
      if (wall.value >= floor) continue;
      particles.x[i] += (floor - wall.value) * wall.nx;
      particles.y[i] += (floor - wall.value) * wall.ny;
    }
  }
};

}  // namespace

const EffectKind wall_clearance{
    "wall_clearance", Stage::motion, false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "walls hold the fluid", "/vessel"});
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<WallClearance>(); }};

}  // namespace rouleau::effects
