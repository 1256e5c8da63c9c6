#pragma once

#include <optional>
#include <vector>

#include "engine/linear/aggregates.h"
#include "engine/operators/standard_mps.h"
#include "engine/particles/neighbour_list.h"

namespace rouleau::effects {

/// What the effects of the published pressure step (eqs. 3, 5, 7 to 9) leave for one another: the
/// arrangement at the predicted positions r* = r + dt u*, with one row for every particle that has a
/// velocity.
struct DensityProjection {
  /// @param list  as the one at the present positions
  DensityProjection(const particles::NeighbourList& list, double spacing)
      : mps(spacing, list.radius()), neighbours(list) {}

  /// Whether the pressure of row i is to be found; in the outlets' buffers it is given.
  bool is_unknown(const particles::ParticleSet& particles, int i) const {
    return has_pressure[i] && (i < particles.active_end() || i >= particles.pressure_end());
  }

  operators::StandardMps mps;
  particles::NeighbourList neighbours;
  operators::KernelWeights weights;  ///< 0 for a pair with a particle that has no pressure

  std::vector<double> density;     ///< [rows] n*, eq. 8
  std::vector<double> source;      ///< [rows] minus the right-hand side of eq. 7
  std::vector<char> has_pressure;  ///< [rows]
  std::vector<double> base;        ///< [active] what the gradient, eq. 5, takes neighbours' pressures against
  std::optional<linear::Aggregates> aggregates;  ///< of the unknowns in their order; none: plain gradients
};

}  // namespace rouleau::effects
