#include "engine/effects/corner_flow.h"

namespace rouleau::effects {

namespace {

class CornerFlow : public Effect {
 public:
  explicit CornerFlow(State& state) { state.corner_flow.emplace(state.outline.walls()); }

  /// Adds what the fits make of the known flow where they should find nothing: its divergence, and its
  /// viscous force less its pressure gradient.
  void apply(State& state) override {
    const auto& particles = state.particles;
    velocity_.assign(2 * particles.x.size(), 0);
    pressure_.assign(particles.x.size(), 0);
    for (int i = 0; i < particles.velocity_end(); ++i) {
      const operators::KnownFlow known = state.corner_flow->at(particles.x[i], particles.y[i]);
      velocity_[2 * i] = known.u;
      velocity_[2 * i + 1] = known.v;
      pressure_[i] = state.viscosity * known.p;
    }
    state.operators.divergences(velocity_.data(), divergence_);
    state.operators.velocity_laplacians(velocity_.data(), laplacian_, weights_);
    state.operators.pressure_gradients(pressure_.data(), slope_);
    for (int i = 0; i < particles.active_end(); ++i) {
      state.source[i] += divergence_[i];
      state.ax[i] += slope_[2 * i] - state.viscosity * laplacian_[2 * i];
      state.ay[i] += slope_[2 * i + 1] - state.viscosity * laplacian_[2 * i + 1];
    }
  }

 private:
  std::vector<double> velocity_, pressure_, divergence_, laplacian_, weights_, slope_;
};

}  // namespace

const EffectKind corner_flow{
    "corner_flow",
    Stage::forces,
    true,
    [](const Case& scene) {
      const auto& speeds = scene.vessel.wall_velocity;
      const bool moves = speeds.lower != 0 || speeds.upper != 0 || speeds.left != 0 || speeds.right != 0;
      if (scene.vessel.shape != Shape::box || scene.vessel.ends != Ends::closed || !moves) {
        return Need{false, "no corner lies between walls that move apart", "/vessel/wall_velocity"};
      }
      return of_accurate_scheme(scene, {true, "velocity jumps in the corners between walls that move apart",
                                        "/vessel/wall_velocity"});
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<CornerFlow>(state); },
    "",
    {},
    {.particle = 400}};

}  // namespace rouleau::effects
