#pragma once

#include <vector>

#include "engine/observe/observer.h"
#include "engine/observe/unit_flow.h"

namespace rouleau::observe {

/// By how much each cell raises the drop of pressure along its vessel, in own units, by the reciprocal
/// theorem (Kim and Karrila, Microhydrodynamics, 1991, ch. 2): with the flow u0 of unit flux through the
/// vessel without cells and its stress s0,
///
///   dp - dp0 = - sum over the nodes of f . u0  +  (lambda - 1) closed integral of u . s0 . n dl
///
/// where f is the force of a node on the fluid, lambda the viscosity inside over that of plasma and n the
/// membrane's outward normal. The second term is what the cell's inside dissipates beyond plasma in its
/// place. Exact in Stokes flow between ends where the flow is developed. Needs the forces of the last step.
/// @return  [cells], 0 for one that has left
std::vector<double> pressure_by_cells(const effects::State& state, const UnitFlow& unit);

/// Hydraulic resistance of the vessel, that without cells, and what each cell adds to it.
extern const ObserverKind hydraulic_resistance;

}  // namespace rouleau::observe
