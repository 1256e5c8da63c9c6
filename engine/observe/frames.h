#pragma once

#include "engine/effects/state.h"
#include "engine/observe/output.h"

namespace rouleau::observe {

/// The moving particles as they are now.
Frame make_frame(const effects::State& state);

}  // namespace rouleau::observe
