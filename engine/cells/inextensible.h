#pragma once

#include <span>
#include <vector>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"
#include "engine/cells/stiffness.h"

namespace rouleau::cells {

/// What holds a membrane's links at their lengths: the tension in each, as the Lagrange multiplier of its
/// length. Empty where nothing does.
struct HeldLinks {
  std::vector<double> length;   ///< [links] that each keeps
  std::vector<double> tension;  ///< [links] force per depth, positive where it pulls

  bool operator==(const HeldLinks&) const = default;
};

/// Links held at the lengths that they have, under the tension of their springs: what was in balance stays
/// so.
HeldLinks hold_links(Ring ring, const Material& material);

/// Of |l / l0 - 1|, the greatest.
double greatest_length_error(Ring ring, const HeldLinks& held);

/// A step of the method of multipliers (Hestenes, J. Optim. Theory Appl. 4 (1969), eq. 5): the rate at which
/// each link grows, over its length, times `gain` is added to its tension. A link that grows is pulled harder
/// until it does not.
/// @param u  [nodes], as `v`: their velocities
void update_tension(Ring ring, std::span<const double> u, std::span<const double> v, double gain,
                    HeldLinks& held);

/// Adds the forces on the nodes, per unit depth: each link's tension, and `modulus` times its strain.
void add_held_forces(Ring ring, const HeldLinks& held, double modulus, std::span<double> fx,
                     std::span<double> fy);

/// Appends two terms a link, as for the springs: along it `modulus` over its length, across it its whole
/// tension over its length where it pulls. `first_node` is added to every node index.
void append_held_stiffness(Ring ring, const HeldLinks& held, double modulus, int first_node,
                           std::vector<Stiffness>& terms);

}  // namespace rouleau::cells
