#include "engine/effects/number_density.h"

namespace rouleau::effects {

namespace {

class NumberDensity : public Effect {
 public:
  void apply(State& state) override {
    DensityProjection& projection = state.projection;
    predict(state);
    projection.weights.fill(projection.mps, projection.neighbours);
    const int rows = projection.neighbours.rows();
    const double expected = projection.mps.density();
    const double scale = 1 / (state.dt * state.dt * expected);
    projection.density.resize(rows);
    projection.source.resize(rows);
    for (int i = 0; i < rows; ++i) {
      projection.density[i] = operators::number_density(projection.neighbours, projection.weights, i);
      projection.source[i] = scale * (projection.density[i] - expected);
    }
    projection.has_pressure.assign(rows, 1);
    projection.aggregates.reset();
  }

 private:
  /// The search is lent the predicted positions in place of the present ones.
  void predict(State& state) {
    auto& particles = state.particles;
    x_ = particles.x;
    y_ = particles.y;
    for (int i = 0; i < particles.inlet_end(); ++i) {
      x_[i] += state.dt * particles.u[i];
      y_[i] += state.dt * particles.v[i];
    }
    x_.swap(particles.x);
    y_.swap(particles.y);
    state.projection.neighbours.build(particles, particles.velocity_end());
    x_.swap(particles.x);
    y_.swap(particles.y);
  }

  std::vector<double> x_, y_;
};

}  // namespace

const EffectKind number_density{
    "number_density",
    Stage::pressure,
    false,
    [](const Case& scene) { return of_published_scheme(scene, "plasma is incompressible: eqs. 7 and 8"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<NumberDensity>(); },
    "",
    {},
    {.particle = 175}};

}  // namespace rouleau::effects
