#include "engine/effects/waveform.h"

#include "engine/case/waveform.h"

namespace rouleau::effects {

namespace {

class Waveform : public Effect {
 public:
  explicit Waveform(State& state) { set_factor(state, state.time); }

  void apply(State& state) override { set_factor(state, state.time + state.dt); }

 private:
  static void set_factor(State& state, double time) {
    state.inflow_factor = waveform_factor(state.scene.inflow, time * state.scales.time());
  }
};

}  // namespace

const EffectKind waveform{
    "waveform",
    Stage::boundaries,
    false,
    [](const Case& scene) {
      if (!is_open(scene.vessel)) return Need{false, "the vessel has no inlet", "/vessel/ends"};
      const bool given = !scene.inflow.waveform.empty();
      return Need{given, given ? "the inflow changes with time" : "the inflow is steady", "/inflow/waveform"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Waveform>(state); },
    "",
    {},
    {.once = 200}};

}  // namespace rouleau::effects
