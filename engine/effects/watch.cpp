#include "engine/effects/watch.h"

#include <algorithm>
#include <cmath>

#include "engine/case/waveform.h"
#include "engine/error/simulation_error.h"

namespace rouleau::effects {

namespace {

// No flow is this many times faster than its mean through the narrowest place.
constexpr double fastest = 30;

class Watch : public Effect {
 public:
  explicit Watch(const State& state)
      : speed_bound_(fastest * largest_factor(state.scene.inflow) * state.outline.height() /
                     state.outline.narrowest()) {}

  void apply(State& state) override {
    const auto& particles = state.particles;
    const double bound = std::min(speed_bound_, state.spacing / state.dt);
    double peak2 = 0;
    for (int i = 0; i < particles.active_end(); ++i) {
      const double speed2 = particles.u[i] * particles.u[i] + particles.v[i] * particles.v[i];
      if (!(speed2 <= bound * bound)) {
        throw breach(state, i, "speed", std::sqrt(speed2) * state.scales.velocity,
                     bound * state.scales.velocity, "m/s");
      }
      if (!std::isfinite(particles.p[i])) {
        throw breach(state, i, "pressure", particles.p[i] * state.scales.pressure(), 0, "Pa");
      }
      if (!std::isfinite(particles.x[i]) || !std::isfinite(particles.y[i])) {
        throw breach(state, i, "position", particles.x[i] * state.scales.length, 0, "m");
      }
      peak2 = std::max(peak2, speed2);
    }
    state.counters.peak_speed = std::max(state.counters.peak_speed, std::sqrt(peak2));
    state.speed = std::sqrt(peak2);
  }

 private:
  static SimulationError breach(const State& state, int i, const char* quantity, double value, double bound,
                                const char* unit) {
    const auto& particles = state.particles;
    return SimulationError({.quantity = quantity,
                            .value = value,
                            .bound = bound,
                            .unit = unit,
                            .time = (state.time + state.dt) * state.scales.time(),
                            .step = state.step + 1,
                            .x = particles.x[i] * state.scales.length,
                            .y = particles.y[i] * state.scales.length,
                            .particle = particles.id[i],
                            .cell = particles.cell[i]});
  }

  double speed_bound_;
};

}  // namespace

const EffectKind watch{
    "watch", Stage::checks, false,
    [](const Case&) { return always("a run must stop at the first wrong value"); },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Watch>(state); }};

}  // namespace rouleau::effects
