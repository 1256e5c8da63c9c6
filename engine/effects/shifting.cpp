#include "engine/effects/shifting.h"

#include <algorithm>
#include <cmath>

#include "engine/particles/periodic.h"

namespace rouleau::effects {

namespace {

constexpr double strength = 0.4;  // spacings a unit of crowding
constexpr double longest = 0.1;   // spacings a step

class Shifting : public Effect {
 public:
  void apply(State& state) override {
    const auto& list = state.neighbours;
    for (int i = state.particles.membrane_end(); i < state.particles.active_end(); ++i) {
      double cx = 0, cy = 0;
      const auto crowd = [&](int j) {
        const double dx = particles::nearest_image(state.next_x[i] - state.next_x[j], list.period_x());
        const double dy = particles::nearest_image(state.next_y[i] - state.next_y[j], list.period_y());
        const double r = std::sqrt(dx * dx + dy * dy);
        const double q = 1 - r / state.near_radius;
        if (q <= 0) return;
        const double f = q * q * q / (r + 1e-9 * state.spacing);
        cx += f * dx;
        cy += f * dy;
      };
      // A pair just outside the near radius may have come into it during the step: take the whole row.
      for (int k = list.begin(i); k < list.end(i); ++k) crowd(list.j[k]);
      for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) crowd(list.ghost[k]);
      const double length = strength * std::hypot(cx, cy);
      const double scale = state.spacing * strength * std::min(1.0, longest / std::max(length, 1e-30));
      state.shift_x[i] += scale * cx;
      state.shift_y[i] += scale * cy;
    }
  }
};

}  // namespace

const EffectKind shifting{
    "shifting", Stage::motion, true,
    [](const Case& scene) { return of_accurate_scheme(scene, always("particles must stay evenly spread")); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Shifting>(); }};

}  // namespace rouleau::effects
