#include "engine/cells/bending.h"

#include <cmath>

#include "engine/cells/hinge.h"

namespace rouleau::cells {

double bending_energy(Ring ring, const Material& material) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += hinge_law(hinge_at(ring, i).angle, material, rest_length_at(ring, material, i)).energy;
  return sum;
}

void add_bending_forces(Ring ring, const Material& material, std::span<double> fx, std::span<double> fy) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Hinge hinge = hinge_at(ring, i);
    const double moment = hinge_law(hinge.angle, material, rest_length_at(ring, material, i)).moment;
    for (std::size_t k = 0; k < 3; ++k) {
      fx[hinge.node[k]] -= moment * hinge.gradient[2 * k];
      fy[hinge.node[k]] -= moment * hinge.gradient[2 * k + 1];
    }
  }
}

void add_printed_bending_forces(Ring ring, const Material& material, std::span<double> fx,
                                std::span<double> fy) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Hinge hinge = hinge_at(ring, i);
    const double force = hinge_law(hinge.angle, material).moment / material.rest_length;
    for (const std::size_t end : {0, 2}) {
      // The gradient points inwards, and its length is the inverse of the link's.
      const double gx = hinge.gradient[2 * end], gy = hinge.gradient[2 * end + 1];
      const double nx = -gx / std::hypot(gx, gy), ny = -gy / std::hypot(gx, gy);
      fx[hinge.node[end]] += force * nx;
      fy[hinge.node[end]] += force * ny;
      fx[i] -= force * nx;
      fy[i] -= force * ny;
    }
  }
}

void append_bending_stiffness(Ring ring, const Material& material, int first_node,
                              std::vector<Stiffness>& terms) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Hinge hinge = hinge_at(ring, i);
    Stiffness term{
        {}, hinge.gradient, hinge_law(hinge.angle, material, rest_length_at(ring, material, i)).slope};
    for (std::size_t k = 0; k < 3; ++k) term.node[k] = first_node + static_cast<int>(hinge.node[k]);
    terms.push_back(term);
  }
}

}  // namespace rouleau::cells
