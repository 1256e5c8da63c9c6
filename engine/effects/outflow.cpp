#include "engine/effects/outflow.h"

namespace rouleau::effects {

namespace {

using particles::Group;
using particles::ParticleSet;

constexpr int buffer_depth = 4;  // spacings

class Outflow : public Effect {
 public:
  explicit Outflow(State& state) : pressure_(state.scene.outflow.pressure[0] / state.scales.pressure()) {
    for (int k = 1; k <= state.rows(); ++k) {
      const double y = state.row_y(k);
      for (int column = 0; column < buffer_depth; ++column) {
        const double x = state.outline.length() + (column + 0.5) * state.spacing;
        const int i = state.particles.add(Group::outlet, x, y);
        state.particles.u[i] = state.developed_velocity(y);
        state.particles.p[i] = pressure_;
      }
    }
  }

  void apply(State& state) override {
    ParticleSet& particles = state.particles;
    const double plane = state.outline.length();
    const double slope = slope_before(state, plane);
    for (int i = particles.membrane_end(); i < particles.inlet_end(); ++i) {
      const double beyond = particles.x[i] - plane;
      if (particles.group[i] == Group::fluid && beyond > 0) {
        particles.group[i] = Group::outlet;
        particles.v[i] = 0;
      }
      if (particles.group[i] != Group::outlet) continue;
      particles.p[i] = pressure_ + slope * beyond;
      if (beyond > buffer_depth * state.spacing) {
        particles.group[i] = Group::dead;
        ++state.counters.absorbed;
      }
    }
  }

 private:
  static double slope_before(const State& state, double plane) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < state.pressure_gx.size(); ++i) {
      const double before = (plane - state.particles.x[i]) / state.spacing;
      if (before < 1.5 || before > 4) continue;
      sum += state.pressure_gx[i];
      ++count;
    }
    return count ? sum / count : 0;
  }

  double pressure_;
};

}  // namespace

const EffectKind outflow{
    "outflow", Stage::boundaries, false,
    [](const Case&) {
      return Need{true, "the vessel's outlet is open", "/outflow"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Outflow>(state); }};

}  // namespace rouleau::effects
