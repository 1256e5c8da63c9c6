#include "engine/effects/watch.h"

#include <algorithm>
#include <cmath>

#include "engine/case/waveform.h"
#include "engine/effects/bounds.h"
#include "engine/effects/breach.h"

namespace rouleau::effects {

namespace {

// No flow is this many times faster than its mean through the narrowest place.
constexpr double fastest = 30;

class Watch : public Effect {
 public:
  explicit Watch(const State& state) : speed_bound_(speed_bound(state)) {}

  void apply(State& state) override {
    check_particles(state);
    if (state.scene.numerics.preset != Preset::paper) check_divergence(state);
  }

 private:
  void check_particles(State& state) const {
    const auto& particles = state.particles;
    const double bound = std::min(speed_bound_, state.spacing / state.dt);
    double peak2 = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
      const double speed2 = particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
      if (!(speed2 <= bound * bound)) {
        throw breach_at(
            state, i,
            {"speed", std::sqrt(speed2) * state.scales.velocity, bound * state.scales.velocity, "m/s"});
      }
      if (!std::isfinite(particles.p[i])) {
        throw breach_at(state, i, {"pressure", particles.p[i] * state.scales.pressure(), 0, "Pa"});
      }
      if (!std::isfinite(particles.x[i]) || !std::isfinite(particles.y[i])) {
        throw breach_at(state, i, {"position", particles.x[i] * state.scales.length, 0, "m"});
      }
      peak2 = std::max(peak2, speed2);
    }
    state.counters.peak_speed = std::max(state.counters.peak_speed, std::sqrt(peak2));
    state.speed = std::sqrt(peak2);
  }

  /// Beside what is wanted there. The published scheme does not aim at none.
  void check_divergence(State& state) {
    operators::interleave(state.particles.u, state.particles.v, velocity_);
    state.operators.divergences(velocity_.data(), divergence_);
    const double scale = state.spacing / std::max(1.0, state.speed);
    double most = 0;
    for (int i = 0; i < state.particles.active_end(); ++i) {
      const double divergence = std::abs(divergence_[i] - state.source[i]) * scale;
      if (!(divergence <= divergence_bound)) {
        throw breach_at(state, i, {"divergence", divergence, divergence_bound});
      }
      most = std::max(most, divergence);
    }
    state.counters.worst_divergence = std::max(state.counters.worst_divergence, most);
  }

  double speed_bound_;
  std::vector<double> velocity_, divergence_;
};

}  // namespace

double speed_bound(const State& state) {
  return fastest * largest_factor(state.scene.inflow) * state.outline.height() / state.outline.narrowest();
}

const EffectKind watch{"watch",
                       Stage::checks,
                       false,
                       [](const Case&) { return always("a run must stop at the first wrong value"); },
                       [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Watch>(state); },
                       "",
                       {},
                       {.particle = 23}};

}  // namespace rouleau::effects
