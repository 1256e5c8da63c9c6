#pragma once

#include <span>
#include <vector>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"
#include "engine/cells/stiffness.h"

namespace rouleau::cells {

/// Energy of the bending springs per unit depth: -(4 B / l0) ln cos(theta / 2) at a node whose links turn by
/// theta, which is B theta^2 / (2 l0) for small angles; quadratic beyond |theta| = 2.8.
double bending_energy(Ring ring, const Material& material);

/// Adds the force on each node, per unit depth: minus the gradient of the energy. It is eq. 11 with its
/// forces scaled by l0 / l; as printed they are the gradient of nothing and exert a net torque.
void add_bending_forces(Ring ring, const Material& material, std::span<double> fx, std::span<double> fy);

/// Adds the force on each node as eq. 11 prints it: with the turning angle theta, (2 B / l0^2) tan(theta / 2)
/// on both neighbours of a node along their links' outward normals, and what balances the two on the node.
void add_printed_bending_forces(Ring ring, const Material& material, std::span<double> fx,
                                std::span<double> fy);

/// Appends one term a node: the slope of its moment, (B / l0) sec^2(theta / 2), along the gradient of theta.
/// `first_node` is added to every node index.
void append_bending_stiffness(Ring ring, const Material& material, int first_node,
                              std::vector<Stiffness>& terms);

}  // namespace rouleau::cells
