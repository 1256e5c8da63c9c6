#include "engine/effects/inflow_flux.h"

namespace rouleau::effects {

namespace {

// In spacings from the inlet plane: where the source is, and the plane up to which flow is balanced.
constexpr double source_depth = 4;
constexpr double balance_depth = 6;

class InflowFlux : public Effect {
 public:
  /// The projection leaves through the balance plane what crosses it before, less the divergences summed
  /// over the particles up to it: the source makes that the wanted flux.
  void apply(State& state) override {
    const auto& particles = state.particles;
    const double volume = state.spacing * state.spacing;
    const double plane = balance_depth * state.spacing;
    const double wanted = state.outline.height() * state.inflow_factor;
    double removed = 0;
    layer_.clear();
    for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
      if (particles.x[i] > plane) continue;
      const double divergence = state.operators.velocity_gradient(i, particles.u.data()).x +
                                state.operators.velocity_gradient(i, particles.v.data()).y;
      removed += volume * (divergence - state.source[i]);
      if (particles.x[i] < source_depth * state.spacing && particles.cell[i] < 0) layer_.push_back(i);
    }
    if (layer_.empty()) return;
    const double flux = operators::measure_flux(particles, state.plane_at(plane), sampler_);
    const double source = (wanted - (flux - removed)) / (volume * static_cast<double>(layer_.size()));
    for (const int i : layer_) state.source[i] += source;
  }

 private:
  std::vector<int> layer_;
  operators::Sampler sampler_;
};

}  // namespace

const EffectKind inflow_flux{
    "inflow_flux",
    Stage::pressure,
    true,
    [](const Case& scene) {
      if (!is_open(scene.vessel)) return Need{false, "the vessel has no inlet", "/vessel/ends"};
      return of_accurate_scheme(scene,
                                {true, "the flux given at the inlet is kept exactly", "/inflow/velocity"});
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<InflowFlux>(); },
    "",
    {},
    {.particle = 3.4, .each = 2450, .count = [](const Work& w) { return w.inlet_rows; }}};

}  // namespace rouleau::effects
