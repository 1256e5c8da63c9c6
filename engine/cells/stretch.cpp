#include "engine/cells/stretch.h"

#include <algorithm>

#include "engine/cells/link.h"

namespace rouleau::cells {

double stretch_energy(Ring ring, const Material& material) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += link_law(link_at(ring, i).length, material, material.rest_length_of(i)).energy;
  return sum;
}

void add_stretch_forces(Ring ring, const Material& material, std::span<double> fx, std::span<double> fy) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const double tension = link_law(link.length, material, material.rest_length_of(i)).tension;
    fx[link.from] += tension * link.ex;
    fy[link.from] += tension * link.ey;
    fx[link.to] -= tension * link.ex;
    fy[link.to] -= tension * link.ey;
  }
}

void append_stretch_stiffness(Ring ring, const Material& material, int first_node,
                              std::vector<Stiffness>& terms) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const LinkLaw law = link_law(link.length, material, material.rest_length_of(i));
    const int from = first_node + static_cast<int>(link.from), to = first_node + static_cast<int>(link.to);
    const double along = law.slope, across = std::max(0.0, law.tension / link.length);
    terms.push_back({{from, to, to}, {-link.ex, -link.ey, link.ex, link.ey, 0.0, 0.0}, along});
    terms.push_back({{from, to, to}, {link.ey, -link.ex, -link.ey, link.ex, 0.0, 0.0}, across});
  }
}

}  // namespace rouleau::cells
