#include "engine/cells/energy_hessian.h"

#include <Eigen/Core>

#include "engine/cells/bending.h"
#include "engine/cells/hinge.h"
#include "engine/cells/link.h"

namespace rouleau::cells {
namespace {

/// The part that depends on the vector between the nodes of one link: its tension, and the turning of its
/// direction under the moments of the hinges at its ends.
Eigen::Matrix2d link_block(const Link& link, const LinkLaw& law, double moment_from, double moment_to) {
  const Eigen::Vector2d along(link.ex, link.ey), across(-link.ey, link.ex);
  const Eigen::Matrix2d mixed = along * across.transpose();
  return law.slope * along * along.transpose() + law.tension / link.length * across * across.transpose() -
         (moment_from - moment_to) / (link.length * link.length) * (mixed + mixed.transpose());
}

}  // namespace

void append_energy_hessian(Ring ring, const Material& material,
                           std::vector<Eigen::Triplet<double>>& entries) {
  std::vector<double> moment(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    moment[i] = hinge_law(hinge_at(ring, i).angle, material).moment;
  }

  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link link = link_at(ring, i);
    const Eigen::Matrix2d block =
        link_block(link, link_law(link.length, material), moment[link.from], moment[link.to]);
    const int from = 2 * static_cast<int>(link.from), to = 2 * static_cast<int>(link.to);
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) {
        entries.emplace_back(from + r, from + c, block(r, c));
        entries.emplace_back(to + r, to + c, block(r, c));
        entries.emplace_back(from + r, to + c, -block(r, c));
        entries.emplace_back(to + r, from + c, -block(r, c));
      }
    }
  }

  std::vector<Stiffness> hinges;
  append_bending_stiffness(ring, material, 0, hinges);
  for (const Stiffness& hinge : hinges) {
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t c = 0; c < 6; ++c) {
        entries.emplace_back(2 * hinge.node[r / 2] + static_cast<int>(r % 2),
                             2 * hinge.node[c / 2] + static_cast<int>(c % 2),
                             hinge.k * hinge.g[r] * hinge.g[c]);
      }
    }
  }
}

}  // namespace rouleau::cells
