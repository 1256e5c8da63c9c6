#pragma once

#include <vector>

#include "engine/particles/particle_set.h"

namespace rouleau::particles {

/// The box that particles can be in; whatever strays beyond it is filed at its rim, so that a run that goes
/// wrong cannot make the search grow.
struct Extent {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Neighbours of every active particle (membrane and fluid) as compressed rows, with the relative position
/// of each pair. In a row the pairs within `near_radius` come first, so the short-ranged operators use a
/// prefix of it. Ghosts stand in rows of their own, and only the near ones.
class NeighbourList {
 public:
  NeighbourList(const Extent& extent, double radius, double near_radius);

  /// Needs sorted particles (`sort_particles`).
  void build(const ParticleSet& particles);

  int rows() const { return static_cast<int>(begin_.size()) - 1; }
  int begin(int i) const { return begin_[i]; }
  int near_end(int i) const { return near_end_[i]; }
  int end(int i) const { return begin_[i + 1]; }
  int ghost_begin(int i) const { return ghost_begin_[i]; }
  int ghost_end(int i) const { return ghost_begin_[i + 1]; }

  double radius() const { return radius_; }
  double near_radius() const { return near_radius_; }
  int longest_row() const { return longest_row_; }

  std::vector<int> j;            ///< [pairs] the neighbour
  std::vector<float> dx, dy, r;  ///< [pairs] its position relative to the particle, and the distance
  std::vector<int> ghost;        ///< [ghost pairs]
  std::vector<float> ghost_r;    ///< [ghost pairs]

 private:
  void file_particles(const ParticleSet& particles);
  void append_pairs(const ParticleSet& particles, int i, const int* others, int count);
  int column(double x) const;
  int row(double y) const;

  Extent extent_;
  double radius_;
  double near_radius_;
  double bin_;  ///< width of the bins: half the radius
  int columns_;
  int rows_;
  int longest_row_ = 0;
  std::vector<int> begin_, near_end_, ghost_begin_;
  std::vector<int> bin_begin_, bin_of_, filed_;
  std::vector<double> filed_x_, filed_y_;
  std::vector<int> near_, far_, near_ghosts_;  ///< found for one particle
};

}  // namespace rouleau::particles
