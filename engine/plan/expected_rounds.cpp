#include "engine/plan/expected_rounds.h"

#include <algorithm>
#include <cmath>

namespace rouleau {

namespace {

// Of the flow and of the particles at the start, from runs: the rounds hardly depend on the scene.
constexpr double settling_rounds = 8;
constexpr double spreading_rounds = 4;
// A flow that starts from rest, and a cell that starts in moving plasma without ends, take some short steps
// and have some taken again.
constexpr double steps_of_a_start = 14;

double times_in(double duration, double interval) {
  return interval > 0 ? std::floor(duration / interval * (1 + 1e-9)) + 1 : 0;
}

}  // namespace

Rounds Rounds::of(const effects::State& start, double dt, double duration) {
  const Case& scene = start.scene;
  Rounds rounds;
  rounds.steps = std::max(1.0, duration / dt);
  rounds.rows = times_in(duration, scene.output.series_interval);
  rounds.frames = times_in(duration, scene.output.frame_interval);
  if (scene.numerics.preset == Preset::paper) return rounds;
  if (initial_flow(scene) == InitialFlow::developed) {
    rounds.settling = settling_rounds;
    rounds.spreading = spreading_rounds;
  } else if (initial_flow(scene) == InitialFlow::rest) {
    rounds.steps += steps_of_a_start;
  }
  return rounds;
}

double Rounds::of_stage(effects::Stage stage) const {
  switch (stage) {
    case effects::Stage::motion:
    case effects::Stage::operators:
      return steps + settling + spreading;
    case effects::Stage::checks:
      return steps;
    default:
      return steps + settling;
  }
}

double expected_time(const effects::EffectKind& kind, const Rounds& rounds, const effects::Work& work) {
  return rounds.of_stage(kind.stage) * effects::cost_of(kind.cost, work);
}

double expected_time(const observe::ObserverKind& kind, const Rounds& rounds, const effects::Work& work) {
  return rounds.starts * effects::cost_of(kind.cost.start, work) +
         rounds.steps * effects::cost_of(kind.cost.step, work) +
         rounds.rows * effects::cost_of(kind.cost.row, work) +
         rounds.frames * effects::cost_of(kind.cost.frame, work);
}

}  // namespace rouleau
