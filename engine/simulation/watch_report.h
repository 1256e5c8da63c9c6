#pragma once

#include "engine/effects/state.h"
#include "engine/simulation/run.h"

namespace rouleau {

/// What the watch saw, into the summary, whose refinements are there: the worst of every watched quantity,
/// and warnings.
void report_watch(const effects::State& state, RunSummary& summary);

}  // namespace rouleau
