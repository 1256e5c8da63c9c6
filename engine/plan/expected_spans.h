#pragma once

#include <vector>

#include "engine/effects/cost.h"
#include "engine/effects/state.h"
#include "engine/plan/expected_rounds.h"

namespace rouleau {

/// A part of a run with one spacing, and what there is to do in it.
struct ExpectedSpan {
  Rounds rounds;
  effects::Work work;
  double step = 0;     ///< s, as it will be taken
  double spacing = 0;  ///< m
};

/// What the counts of a plan are at its start.
struct StartCounts {
  double particles = 0, membrane_nodes = 0, wall_nodes = 0;
};

/// The parts that a run will have, in order: more than one where a cell is foreseen to become too thin for
/// the spacing at the start.
/// @param spacing  at the start, m
/// @param step     the planned one there, s
/// @param fastest  m/s, of the fluid
std::vector<ExpectedSpan> expected_spans(const effects::State& start, const StartCounts& counts,
                                         double spacing, double step, double fastest);

/// In ns on the machine to which costs refer, of what no effect owns: the copy of the state that a step
/// keeps.
double expected_time_of_steps(const ExpectedSpan& span);
/// In s, of a process that runs a case: until its first step.
inline constexpr double starting_time = 0.045;

/// Of a process that runs it, bytes.
double expected_memory(const std::vector<ExpectedSpan>& spans);

}  // namespace rouleau
