#pragma once

#include "engine/effects/state.h"

namespace rouleau::observe {

/// Scalar shear stress of the plasma around a cell that has not left, in own units: mu sqrt(2 e:e) with the
/// rate of strain e, which is the von Mises-like measure of the stress tensor (Bludszuweit, Artif. Organs 19,
/// 583 (1995)) and in simple shear mu times the shear rate. The mean over the present length of the membrane.
///
/// At each node the velocity is fitted by least squares to the membrane and to what is outside it alone,
/// weight (1 - r/radius)^2, for the velocity gradient jumps there: a quadratic about the node's velocity,
/// exact for quadratic flow; in a gap that carries none a linear one. Nodes that see too little for that
/// count for nothing. Needs the neighbours of the present positions.
double scalar_shear_stress(const effects::State& state, const effects::CellState& cell);

}  // namespace rouleau::observe
