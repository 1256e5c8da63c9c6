#pragma once

#include <span>
#include <vector>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"
#include "engine/cells/stiffness.h"

namespace rouleau::cells {

/// Energy of the stretch springs per unit depth. A link of length l holds
/// (E_s / l0) [(l - l0)^2 / 2 + c (l - 0.8 l0)^2 / 2], the second term only below 0.8 l0, where with c =
/// `crush_stiffening` it keeps the nodes at a cell's trailing tip from collapsing onto one another.
double stretch_energy(Ring ring, const Material& material);

/// Adds the force on each node, per unit depth: minus the gradient of the energy (eq. 10).
void add_stretch_forces(Ring ring, const Material& material, std::span<double> fx, std::span<double> fy);

/// Appends two terms a link: along it the slope of its tension N, across it N / l where it pulls.
/// `first_node` is added to every node index.
void append_stretch_stiffness(Ring ring, const Material& material, int first_node,
                              std::vector<Stiffness>& terms);

}  // namespace rouleau::cells
