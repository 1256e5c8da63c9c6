#pragma once

#include <optional>

#include "engine/effects/state.h"

namespace rouleau {

/// By how much a run is expected to differ from one with half of its spacing and step: of an error of second
/// order, three quarters of it. From runs of few scenes (docs/plan.md): a factor of two either way is usual.
struct ExpectedError {
  double velocity = 0;  ///< root mean square all over the vessel at the end, over that of the velocity
  std::optional<double> tau{};  ///< root mean square over the run, relative; none without cells
};

/// What `ExpectedError` is relative to, for a person.
extern const char* const expected_error_is;

/// @param spacing  in the last part of the run, m
/// @param dt       the planned step, s
/// @param usual_dt the step that the plan would choose, s
ExpectedError expect_error(const effects::State& start, double spacing, double dt, double usual_dt);

}  // namespace rouleau
