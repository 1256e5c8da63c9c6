#include "engine/effects/periodicity.h"

#include <cmath>

#include "engine/cells/shape.h"

namespace rouleau::effects {

namespace {

/// What takes a position back between 0 and the period.
double whole_periods(double position, double period) {
  return period > 0 ? period * std::floor(position / period) : 0;
}

void fold(std::vector<double>& positions, int begin, int end, double period) {
  if (period <= 0) return;
  for (int i = begin; i < end; ++i) positions[i] -= whole_periods(positions[i], period);
}

/// A cell stays whole: it follows the centroid of its area.
void fold_cell(const State& state, const CellState& cell, particles::ParticleSet& particles) {
  const cells::Shape shape = cells::measure(state.ring(cell));
  const double away_x = whole_periods(shape.x, state.outline.period_x());
  const double away_y = whole_periods(shape.y, state.outline.period_y());
  for (int node = cell.first_node; node < cell.first_node + cell.nodes; ++node) {
    particles.x[node] -= away_x;
    particles.y[node] -= away_y;
  }
}

class Periodicity : public Effect {
 public:
  void apply(State& state) override {
    auto& particles = state.particles;
    for (const CellState& cell : state.cells) fold_cell(state, cell, particles);
    fold(particles.x, particles.membrane_end(), particles.active_end(), state.outline.period_x());
    fold(particles.y, particles.membrane_end(), particles.active_end(), state.outline.period_y());
  }
};

}  // namespace

const EffectKind periodicity{
    "periodicity",
    Stage::boundaries,
    false,
    [](const Case& scene) {
      const bool periodic = scene.vessel.ends == Ends::periodic;
      return Need{periodic, periodic ? "the vessel repeats itself" : "the vessel does not repeat itself",
                  "/vessel/ends"};
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Periodicity>(); },
    "",
    {},
    {.particle = 0.5}};

}  // namespace rouleau::effects
