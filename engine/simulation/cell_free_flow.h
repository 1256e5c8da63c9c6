#pragma once

#include <memory>

#include "engine/effects/state.h"

namespace rouleau {

/// The steady flow through the vessel of a case without its cells, fed at the inflow's velocity without its
/// waveform: stepped until its resistance changes by less than 3e-4 within H^2/nu, or for 300 steps.
/// @throws SimulationError where that goes unstable
std::unique_ptr<const effects::State> cell_free_flow(const Case& resolved);

}  // namespace rouleau
