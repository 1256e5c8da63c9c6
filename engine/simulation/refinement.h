#pragma once

#include "engine/effects/state.h"

namespace rouleau {

/// The same moment at a finer spacing. Each cell keeps its area, its shape and the strain of its membrane;
/// the plasma keeps its momentum. Velocities and pressures are sampled, the pressures on the same side of
/// every membrane.
/// @param spacing  in own units; a whole number of them make the vessel's height
effects::State refined(const effects::State& state, double spacing);

/// Gives every cell nodes anew, a spacing apart along its membrane as it is now; all other particles stay as
/// they are. Area, shape and strain are kept, as above.
void renew_nodes(effects::State& state);

}  // namespace rouleau
