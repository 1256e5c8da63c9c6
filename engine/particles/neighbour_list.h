#pragma once

#include <vector>

#include "engine/particles/bins.h"
#include "engine/particles/particle_set.h"

namespace rouleau::particles {

/// Neighbours of every active particle (membrane and fluid; of more on request) as compressed rows, with the
/// relative position of each pair. In a row the pairs within `near_radius` come first, so the short-ranged
/// operators use a prefix of it. Ghosts stand in rows of their own, and only the near ones. In a periodic
/// direction a pair is that of the nearest images, and particles may be outside [0, period).
class NeighbourList {
 public:
  /// @param period_x, period_y  0: not periodic; else at least twice the radius
  NeighbourList(const Extent& extent, double radius, double near_radius, double period_x = 0,
                double period_y = 0);

  /// Needs sorted particles (`sort_particles`).
  void build(const ParticleSet& particles) { build(particles, particles.active_end()); }
  /// The same for the first `rows` particles.
  void build(const ParticleSet& particles, int rows);

  int rows() const { return static_cast<int>(begin_.size()) - 1; }
  int begin(int i) const { return begin_[i]; }
  int near_end(int i) const { return near_end_[i]; }
  int end(int i) const { return begin_[i + 1]; }
  int ghost_begin(int i) const { return ghost_begin_[i]; }
  int ghost_end(int i) const { return ghost_begin_[i + 1]; }

  double radius() const { return radius_; }
  double near_radius() const { return near_radius_; }
  double period_x() const { return axis_x_.period(); }
  double period_y() const { return axis_y_.period(); }
  int longest_row() const { return longest_row_; }

  std::vector<int> j;            ///< [pairs] the neighbour
  std::vector<float> dx, dy, r;  ///< [pairs] its position relative to the particle, and the distance
  std::vector<int> ghost;        ///< [ghost pairs]
  std::vector<float> ghost_r;    ///< [ghost pairs]

 private:
  struct Found {
    std::vector<int> id;
    std::vector<float> dx, dy;
  };

  void append_row(int i, float x, float y);
  void append_ghosts(float x, float y);

  double radius_;
  double near_radius_;
  BinAxis axis_x_, axis_y_;
  Bins carriers_, ghosts_;  ///< of a velocity, and of none
  int longest_row_ = 0;
  std::vector<int> begin_, near_end_, ghost_begin_;
  Surroundings carriers_around_, ghosts_around_;  ///< one bin
  Found near_, far_;                              ///< by one particle
};

}  // namespace rouleau::particles
