#pragma once

#include "engine/effects/state.h"

namespace rouleau {

/// The initial arrangement, in this order: membrane nodes first, so that they keep their indices.

/// Puts each cell's rest shape where the case wants it and records what tau and the area refer to.
/// @throws CaseError where a cell has no rest shape
void place_cells(effects::State& state);

/// Fills the vessel with fluid on rows along x, staggered as the inlet's lanes are, with the flow that
/// the case starts with; leaves out places too near a wall or a membrane.
void place_fluid(effects::State& state);

/// Nodes on the true wall, which move as the wall does, and three layers of ghosts behind it.
void place_walls(effects::State& state);

}  // namespace rouleau
