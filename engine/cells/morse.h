#pragma once

#include <span>
#include <vector>

#include "engine/cells/contact.h"

namespace rouleau::cells {

/// Adhesion of two membranes across a gap, energy per length (and unit depth) of facing membrane: the Morse
/// potential of Liu and Liu, J. Comput. Phys. 220 (2006), and Zhang, Johnson and Popel, J. Biomech. 41
/// (2008),
///   phi = D (exp(2 beta (r0 - r)) - 2 exp(beta (r0 - r))),
/// least (-D) at r0, where there is no force. From r0 + 3/beta on it is faded out, so that force and slope go
/// to nothing at `reach`, r0 + 5/beta, continuously; the potential alone would be 0.013 D there.
struct MorseLaw {
  double depth = 0;     ///< D, energy per area
  double distance = 0;  ///< r0
  double scaling = 0;   ///< beta, an inverse length

  double reach() const { return distance + 5 / scaling; }
  double energy(double gap) const;
  double force(double gap) const;  ///< positive where it pushes apart
  double slope(double gap) const;  ///< of the force, turned positive; negative from r0 + ln 2 / beta on
};

/// Appends what every node of `a` has to do with the links of `b`, as `append_contacts` does it, with half of
/// the length of membrane that the node stands for as weight: both ways together are an energy per length
/// that does not depend on where the nodes are, or how many.
void append_adhesion(const LinkBoxes& a, int first_a, const LinkBoxes& b, int first_b, double reach,
                     std::vector<Contact>& contacts);

/// Adds minus the gradient of the energy of contacts whose points are nodes of `a`: that along the normals,
/// and, as the energy is per length of membrane, a tension along the links of `a`. Two rings give each other
/// no net force and no net torque.
void add_adhesion_forces(std::span<const Contact> contacts, Ring a, int first_a, const MorseLaw& law,
                         std::span<double> fx, std::span<double> fy);

}  // namespace rouleau::cells
