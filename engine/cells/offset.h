#pragma once

#include <vector>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// The nodes of a ring, each moved by `way` along its outward normal, across the chord of its neighbours.
/// @param x  [nodes], as `y`: where to; of any length before
void offset(Ring ring, double way, std::vector<double>& x, std::vector<double>& y);

}  // namespace rouleau::cells
