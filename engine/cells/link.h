#pragma once

#include <cmath>
#include <cstddef>

#include "engine/cells/material.h"
#include "engine/cells/ring.h"

namespace rouleau::cells {

/// The spring from node `from` to the next one.
struct Link {
  std::size_t from, to;
  double length;
  double ex, ey;  ///< unit vector along it
};

inline Link link_at(Ring ring, std::size_t from) {
  const std::size_t to = ring.next(from);
  const double dx = ring.x[to] - ring.x[from], dy = ring.y[to] - ring.y[from];
  const double length = std::sqrt(dx * dx + dy * dy);
  return {from, to, length, dx / length, dy / length};
}

/// Eq. 10 as the derivative of an energy, with a second spring that resists crushing.
struct LinkLaw {
  double energy;
  double tension;  ///< dE/dl, positive when stretched
  double slope;    ///< d2E/dl2
};

/// Where a cell squeezes past an obstacle the nodes of its trailing tip are swept together. Eq. 10 alone lets
/// them collapse to a fraction of the fluid's spacing, so below 0.8 l0 the link stiffens, by default
/// elevenfold. `rest_length` is the link's own l0.
inline LinkLaw link_law(double length, const Material& material, double rest_length) {
  constexpr double crush_ratio = 0.8;
  const double spring = material.stretch_modulus / rest_length;
  const double stretch = length - rest_length;
  LinkLaw law{spring * stretch * stretch / 2.0, spring * stretch, spring};
  const double crush = length - crush_ratio * rest_length;
  if (crush < 0.0) {
    const double crush_spring = material.crush_stiffening * spring;
    law.energy += crush_spring * crush * crush / 2.0;
    law.tension += crush_spring * crush;
    law.slope += crush_spring;
  }
  return law;
}

inline LinkLaw link_law(double length, const Material& material) {
  return link_law(length, material, material.rest_length);
}

}  // namespace rouleau::cells
