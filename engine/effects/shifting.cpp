#include "engine/effects/shifting.h"

#include <algorithm>
#include <cmath>

#include "engine/simd/kernels.h"

namespace rouleau::effects {

namespace {

constexpr double strength = 0.4;  // spacings a unit of crowding
constexpr double longest = 0.1;   // spacings a step

class Shifting : public Effect {
 public:
  void apply(State& state) override {
    const auto& particles = state.particles;
    const auto& list = state.neighbours;
    moved_.resize(2 * static_cast<std::size_t>(particles.size()));
    for (int i = 0; i < particles.size(); ++i) {
      moved_[2 * i] = static_cast<float>(state.next_x[i] - particles.x[i]);
      moved_[2 * i + 1] = static_cast<float>(state.next_y[i] - particles.y[i]);
    }
    crowding_.resize(2 * static_cast<std::size_t>(list.rows()));
    // A pair just outside the near radius may have come into it during the step: whole rows are taken.
    simd::kernels().crowding(list.pair_rows(), list.dx.data(), list.dy.data(), moved_.data(),
                             static_cast<float>(state.near_radius), crowding_.data());
    for (int i = particles.membrane_end(); i < list.rows(); ++i) {
      double cx = crowding_[2 * i], cy = crowding_[2 * i + 1];
      for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) {
        const double dx = moved_[2 * i] - list.ghost_dx[k];
        const double dy = moved_[2 * i + 1] - list.ghost_dy[k];
        const double r = std::sqrt(dx * dx + dy * dy);
        const double q = std::max(1 - r / state.near_radius, 0.0);
        const double f = q * q * q / (r + 1e-9 * state.spacing);
        cx += f * dx;
        cy += f * dy;
      }
      const double length = strength * std::sqrt(cx * cx + cy * cy);
      const double scale = state.spacing * strength * std::min(1.0, longest / std::max(length, 1e-30));
      state.shift_x[i] += scale * cx;
      state.shift_y[i] += scale * cy;
    }
  }

 private:
  std::vector<float> moved_, crowding_;
};

}  // namespace

const EffectKind shifting{
    "shifting",
    Stage::motion,
    true,
    [](const Case& scene) { return of_accurate_scheme(scene, always("particles must stay evenly spread")); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Shifting>(); },
    "",
    {},
    {.particle = 38}};

}  // namespace rouleau::effects
