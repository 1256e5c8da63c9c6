#include "engine/cells/bending.h"

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
