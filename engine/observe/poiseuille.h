#pragma once

#include "engine/effects/state.h"

namespace rouleau::observe {

/// Whether the flow becomes a parabola that is known: in an open straight vessel with steady inflow and
/// nothing in it.
bool becomes_parabola(const Case& scene);

/// Mean relative deviation of the axial velocity from the parabola (eq. 22, against eq. 21 with its sign
/// mended) over the plasma between 80 % and 95 % of the vessel's length: 64 to 76 um in the study's.
double poiseuille_deviation(const effects::State& state);

}  // namespace rouleau::observe
