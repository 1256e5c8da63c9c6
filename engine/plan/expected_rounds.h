#pragma once

#include "engine/effects/cost.h"
#include "engine/effects/effect.h"
#include "engine/effects/state.h"
#include "engine/observe/observer.h"

namespace rouleau {

/// How often a part of a run (or a run that keeps its spacing) applies what the plan holds.
struct Rounds {
  double starts = 1;     ///< of the whole run: 0 in a part that goes on from another
  double steps = 0;      ///< taken again ones included
  double settling = 0;   ///< of the flow at the start, which is no step
  double spreading = 0;  ///< of the particles, before that
  double rows = 0;       ///< of the series
  double frames = 0;

  /// @param dt  the planned step, s
  static Rounds of(const effects::State& start, double dt, double duration);

  double of_stage(effects::Stage stage) const;
};

/// What an effect takes in these rounds, in ns on the machine to which costs refer.
double expected_time(const effects::EffectKind& kind, const Rounds& rounds, const effects::Work& work);
/// The same of an observer.
double expected_time(const observe::ObserverKind& kind, const Rounds& rounds, const effects::Work& work);

}  // namespace rouleau
