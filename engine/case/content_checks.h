#pragma once

#include "engine/case/case.h"
#include "engine/case/faults.h"
#include "engine/case/vessel_outline.h"

namespace rouleau {

/// Adds a fault for every thrombus and cell that does not fit the vessel or another one. Those in which
/// `faults` already names a fault are left out.
/// @param outline  of the scene's vessel
void check_contents(const Case& scene, const VesselOutline& outline, Faults& faults);

}  // namespace rouleau
