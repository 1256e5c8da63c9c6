#include "engine/cells/inextensible.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/link.h"
#include "engine/cells/resample.h"

namespace rouleau::cells {

namespace {

double strain_of(const Link& link, const HeldLinks& held) {
  return link.length / held.length[link.from] - 1;
}

double whole_tension(const Link& link, const HeldLinks& held, double modulus) {
  return held.tension[link.from] + modulus * strain_of(link, held);
}

}  // namespace

HeldLinks hold_links(Ring ring, const Material& material) {
  HeldLinks held{link_lengths(ring), {}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    held.tension.push_back(link_law(held.length[i], material, material.rest_length_of(i)).tension);
  }
  return held;
}

double greatest_length_error(Ring ring, const HeldLinks& held) {
  double most = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    most = std::max(most, std::abs(strain_of(link_at(ring, i), held)));
  }
  return most;
}

void update_tension(Ring ring, std::span<const double> u, std::span<const double> v, double gain,
                    HeldLinks& held) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const double rate =
        ((u[link.to] - u[link.from]) * link.ex + (v[link.to] - v[link.from]) * link.ey) / link.length;
    held.tension[i] += gain * rate;
  }
}

void add_held_forces(Ring ring, const HeldLinks& held, double modulus, std::span<double> fx,
                     std::span<double> fy) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const double tension = whole_tension(link, held, modulus);
    fx[link.from] += tension * link.ex;
    fy[link.from] += tension * link.ey;
    fx[link.to] -= tension * link.ex;
    fy[link.to] -= tension * link.ey;
  }
}

void append_held_stiffness(Ring ring, const HeldLinks& held, double modulus, int first_node,
                           std::vector<Stiffness>& terms) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const int from = first_node + static_cast<int>(link.from), to = first_node + static_cast<int>(link.to);
    const double across = std::max(0.0, whole_tension(link, held, modulus) / link.length);
    terms.push_back(
        {{from, to, to}, {-link.ex, -link.ey, link.ex, link.ey, 0.0, 0.0}, modulus / held.length[i]});
    terms.push_back({{from, to, to}, {link.ey, -link.ex, -link.ey, link.ex, 0.0, 0.0}, across});
  }
}

}  // namespace rouleau::cells
