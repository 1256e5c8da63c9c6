#pragma once

#include "engine/effects/state.h"
#include "engine/observe/output.h"
#include "engine/observe/wall_shear.h"

namespace rouleau::observe {

/// The moving particles as they are now, with the fields that the case asks for.
Frame make_frame(const effects::State& state, const WallShear& wall_shear);

}  // namespace rouleau::observe
