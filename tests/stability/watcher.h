#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/effects/state.h"

namespace rouleau::stability {

/// The worst that a quantity came to, and where and when. SI units.
struct Worst {
  double value = 0;
  double bound = 0;
  double time = 0;
  double x = 0, y = 0;
};

/// By the quantity's name.
using WorstOf = std::map<std::string, Worst>;

/// Looks at a run after every step. What it finds does not come from the engine's own checks.
class Watcher {
 public:
  Watcher();

  void look(const effects::State& state);

  /// not_finite: particles whose position, velocity or pressure is not finite.
  /// crossing_edges: pairs of links, of one membrane or of two, that cross.
  /// wrong_side: particles inside a cell that they do not belong to, outside of their own, or behind a wall.
  /// area: |A/A0 - 1| of a cell.
  /// divergence: |div u| d0/U of a particle, by the fits that the step was solved with, and U the unit of
  /// velocity: the inflow's mean, a lid's, or what drives the flow. Under a lid less what the fits make of
  /// the singular flow in the corners.
  const WorstOf& worst() const { return worst_; }

 private:
  void note(const effects::State& state, const char* name, double value, double x, double y);
  void look_at_values(const effects::State& state);
  void look_at_sides(const effects::State& state);
  void look_at_edges(const effects::State& state);
  void look_at_areas(const effects::State& state);
  void look_at_divergence(const effects::State& state);

  WorstOf worst_;
  std::vector<double> velocity_, divergence_;
};

/// Where the area that a cell encloses has its centroid, in m.
struct Centroid {
  double x = 0, y = 0;
};
Centroid centroid_of(const effects::State& state, std::size_t cell);

}  // namespace rouleau::stability
