#include "engine/effects/wall_clearance.h"

#include <cmath>

namespace rouleau::effects {

namespace {

// In spacings.
constexpr double clearance = 0.4;
constexpr double torn_clearance = 1.4;  // the least with which a lid-driven cavity is steady

class WallClearance : public Effect {
 public:
  explicit WallClearance(const State& state) {
    for (const geometry::WallNode& node : state.outline.wall_nodes(state.spacing, 0)) {
      if (node.torn) torn_corners_.push_back({node.x, node.y});
    }
  }

  void apply(State& state) override {
    auto& particles = state.particles;
    const double least = clearance * state.spacing;
    for (int i = 0; i < particles.active_end(); ++i) {
      const auto wall = state.outline.distance(particles.x[i], particles.y[i]);
      const double floor = i < particles.membrane_end() ? 0 : least;
      if (wall.value < floor) {
        particles.x[i] += (floor - wall.value) * wall.nx;
        particles.y[i] += (floor - wall.value) * wall.ny;
      }
      for (const auto& corner : torn_corners_) keep_off(corner, state, i);
    }
  }

 private:
  /// In a corner whose walls move apart the velocity jumps: no fit that is taken there holds.
  static void keep_off(const geometry::Point& corner, State& state, int i) {
    auto& particles = state.particles;
    const double dx = particles.x[i] - corner[0], dy = particles.y[i] - corner[1];
    const double distance = std::hypot(dx, dy), floor = torn_clearance * state.spacing;
    if (distance >= floor || distance <= 0) return;
    particles.x[i] = corner[0] + dx * floor / distance;
    particles.y[i] = corner[1] + dy * floor / distance;
  }

  std::vector<geometry::Point> torn_corners_;
};

}  // namespace

const EffectKind wall_clearance{
    "wall_clearance",
    Stage::motion,
    false,
    [](const Case& scene) {
      return of_accurate_scheme(scene, {true, "walls hold the fluid", "/vessel"});
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<WallClearance>(state); },
    "",
    {},
    {.particle = 5.7, .wall_node = 10}};

}  // namespace rouleau::effects
