#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/cells/link_boxes.h"
#include "engine/cells/stiffness.h"

namespace rouleau::cells {

/// Repulsion across a gap: the force F = f (1 - q)^2 / q with q = gap / range, nothing from q = 1 on; below
/// q = 0.05, and behind a wall, it stays at what it is there, so that a surface already crossed is still
/// pushed out. It is a barrier of the kind of Li et al., ACM Trans. Graph. 39(4), 49 (2020), with a force
/// that has one term.
struct ContactLaw {
  double strength = 0;  ///< f, force per depth: the repulsion where the gap is 0.38 of the range
  double range = 0;

  double energy(double gap) const;
  double force(double gap) const;
  double slope(double gap) const;  ///< of the force, turned positive
};

/// A point and the link that it is near, or a fixed point and a link, or a node and a fixed surface.
struct Contact {
  int point = -1;             ///< its node; -1: it does not move
  std::array<int, 2> link{};  ///< its nodes; twice the same one: a node
  double s = 0;               ///< where along the link the nearest place is
  double nx = 0, ny = 0;      ///< unit normal from the link to the point
  double gap = 0;             ///< between the surfaces; behind a wall negative
  double weight = 1;          ///< -1: counted too often by its neighbours (see append_contacts)
};

/// Appends the contacts of every node of `a` with the links of `b` that are nearer than `range`: each link
/// counts, and each node between two links is taken off once, after Li, Kaufman and Jiang, "Convergent
/// incremental potential contact" (arXiv:2307.15908). Facing a straight or bulging row of links that is the
/// distance to the row, with no doubling at its nodes; and as the distance to each link has a continuous
/// gradient, so has the sum. Both ways together are the contact of two membranes, segment to segment: where
/// two segments do not cross they are nearest to one another at an end of one.
/// @param first_a, first_b  added to the node indices
/// @param skip  for a ring with itself: links that this many links or fewer lie between are left out; -1 for
///              two rings
void append_contacts(const LinkBoxes& a, int first_a, const LinkBoxes& b, int first_b, double range, int skip,
                     std::vector<Contact>& contacts);

/// The other way round, for a fixed disc (of radius 0: a corner) that may be nearest to a ring between two of
/// its nodes: the contacts of the disc with the ring's links.
void append_disc_contacts(const LinkBoxes& ring, int first, std::array<double, 2> centre, double radius,
                          double range, std::vector<Contact>& contacts);

/// Of a law that has energy(gap), force(gap) and slope(gap), as `ContactLaw` does.
template <class Law>
double contact_energy(std::span<const Contact> contacts, const Law& law) {
  double sum = 0;
  for (const Contact& contact : contacts) sum += contact.weight * law.energy(contact.gap);
  return sum;
}

/// Adds minus the gradient of the energy: along the normal, shared (1 - s, s) between the link's nodes, so
/// that two membranes give each other no net force and no net torque.
template <class Law>
void add_contact_forces(std::span<const Contact> contacts, const Law& law, std::span<double> fx,
                        std::span<double> fy) {
  for (const Contact& contact : contacts) {
    const double force = contact.weight * law.force(contact.gap);
    const auto push = [&](int node, double share) {
      fx[node] += share * force * contact.nx;
      fy[node] += share * force * contact.ny;
    };
    if (contact.point >= 0) push(contact.point, 1);
    push(contact.link[0], -(1 - contact.s));
    push(contact.link[1], -contact.s);
  }
}

/// Appends one term for each contact whose weighted slope is positive: that slope, along its normal.
template <class Law>
void append_contact_stiffness(std::span<const Contact> contacts, const Law& law,
                              std::vector<Stiffness>& terms) {
  for (const Contact& contact : contacts) {
    const double slope = contact.weight * law.slope(contact.gap);
    if (slope <= 0) continue;
    const auto [from, to] = contact.link;
    const double point = contact.point >= 0 ? 1 : 0, near = -(1 - contact.s), far = -contact.s;
    const double nx = contact.nx, ny = contact.ny;
    terms.push_back({{contact.point >= 0 ? contact.point : from, from, to},
                     {point * nx, point * ny, near * nx, near * ny, far * nx, far * ny},
                     slope});
  }
}

}  // namespace rouleau::cells
