#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"

namespace rouleau::cells {

/// Appends the exact second derivatives of stretch plus bending energy by the coordinates x0, y0, x1, y1, …
/// The places they fill depend on the number of nodes alone.
void append_energy_hessian(Ring ring, const Material& material, std::vector<Eigen::Triplet<double>>& entries);

}  // namespace rouleau::cells
