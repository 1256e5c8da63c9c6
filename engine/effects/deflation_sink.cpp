#include "engine/effects/deflation_sink.h"

#include <algorithm>

#include "engine/effects/deflation.h"

namespace rouleau::effects {

namespace {

class DeflationSink : public Effect {
 public:
  bool awake(const State& state) override {
    return std::any_of(state.cells.begin(), state.cells.end(),
                       [](const CellState& cell) { return cell.area_rate != 0; });
  }

  void apply(State& state) override {
    for (int i = state.particles.membrane_end(); i < state.particles.active_end(); ++i) {
      if (state.particles.cell[i] >= 0) state.source[i] += state.cells[state.particles.cell[i]].area_rate;
    }
  }
};

}  // namespace

const EffectKind deflation_sink{
    "deflation_sink",
    Stage::pressure,
    false,
    [](const Case& scene) { return of_accurate_scheme(scene, deflation.need(scene)); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<DeflationSink>(); },
    deflation.rests,
    {},
    {.particle = 1}};

}  // namespace rouleau::effects
