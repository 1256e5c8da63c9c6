#include "engine/effects/sedimentation.h"

#include "engine/cells/ring.h"

namespace rouleau::effects {

namespace {

constexpr double gravity = 9.81;  // m/s2

class Sedimentation : public CellEffect {
 public:
  explicit Sedimentation(const State& state)
      : fall_(gravity * parameter(state.scene, sedimentation, "density_difference") /
              state.scene.plasma.density / state.scales.acceleration()) {}

  void apply(State& state) override {
    const auto& particles = state.particles;
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      if (state.cells[c].departure) continue;
      double covered = 0;
      for (int i = 0; i < particles.active_end(); ++i) covered += area_in(state, i, c);
      // A cell's weight is that of the area it encloses, whatever its particles cover.
      const double fall = fall_ * cells::area(state.ring(state.cells[c])) / covered;
      const double square = state.spacing * state.spacing;
      for (int i = 0; i < particles.active_end(); ++i) state.ay[i] -= fall * area_in(state, i, c) / square;
    }
  }

 private:
  /// A membrane node has half of its fluid inside.
  static double area_in(const State& state, int i, std::size_t c) {
    if (state.particles.cell[i] != static_cast<int>(c)) return 0;
    return (i < state.particles.membrane_end() ? 0.5 : 1) * state.spacing * state.spacing;
  }

  double fall_;  ///< acceleration, in own units
};

}  // namespace

const EffectKind sedimentation{
    "sedimentation",
    Stage::forces,
    true,
    [](const Case& scene) {
      return on_request(needs_cells(scene, "cells can sink"),
                        "cells are as heavy as plasma unless asked for");
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Sedimentation>(state); },
    CellEffect::rests,
    {{.name = "density_difference",
      .unit = "kg/m3",
      .description = "Of a cell's inside from plasma.",
      .fallback = 75,
      .least = -1000,
      .most = 1000}}};

}  // namespace rouleau::effects
