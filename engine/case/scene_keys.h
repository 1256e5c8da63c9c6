#pragma once

#include "engine/case/case_keys.h"

namespace rouleau {

/// The keys that say what there is: the vessel, what flows through it and what is in it.
Key vessel_key();
Key plasma_key();
Key inflow_key();
Key outflow_key();
Key body_acceleration_key();
Key initial_key();
Key thrombi_key();
Key cells_key();

}  // namespace rouleau
