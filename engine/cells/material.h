#pragma once

#include <cstddef>
#include <vector>

namespace rouleau::cells {

/// Elastic constants of a membrane, per unit depth, so that they stay the same when the nodes are refined.
/// Against the spring constants of the published model: E_s = k_s l0 / d0, B = k_b l0^2 / (2 d0).
struct Material {
  double stretch_modulus;          ///< E_s, the tension at unit strain: force per depth
  double bend_modulus;             ///< B, the bending moment per curvature: energy
  double rest_length;              ///< l0, the unstretched length of every link
  double crush_stiffening = 10.0;  ///< added slope of a link below 0.8 l0, over E_s / l0; 0 is eq. 10 alone
  std::vector<double> rest_lengths{};  ///< of each link, where its nodes were placed anew; empty: all are l0

  double rest_length_of(std::size_t link) const {
    return rest_lengths.empty() ? rest_length : rest_lengths[link];
  }
};

}  // namespace rouleau::cells
