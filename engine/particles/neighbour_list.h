#pragma once

#include <vector>

#include "engine/particles/bins.h"
#include "engine/particles/particle_set.h"
#include "engine/particles/particle_sorter.h"
#include "engine/simd/kernels.h"

namespace rouleau::particles {

/// Neighbours of every active particle (membrane and fluid; of more on request) as rows of pairs, with the
/// relative position of each pair. In a row the pairs within `near_radius` come first, so the short-ranged
/// operators use a prefix of it; rows are padded to whole vectors with pairs of a particle with itself at
/// distance `radius`. Ghosts stand in rows of their own, and only the near ones. In a periodic direction a
/// pair is that of the nearest images, and particles may be outside [0, period).
class NeighbourList {
 public:
  /// @param period_x, period_y  0: not periodic; else at least twice the radius
  NeighbourList(const Extent& extent, double radius, double near_radius, double period_x = 0,
                double period_y = 0);

  /// Puts the particles into the order in which their neighbours are found fastest (as `sort_particles`).
  void sort(ParticleSet& particles) { sorter_.sort(particles, grid_); }

  /// Needs sorted particles.
  void build(const ParticleSet& particles) { build(particles, particles.active_end()); }
  /// The same for the first `rows` particles.
  void build(const ParticleSet& particles, int rows);

  int rows() const { return static_cast<int>(begin_.size()) - 1; }
  int begin(int i) const { return begin_[i]; }
  int near_end(int i) const { return near_end_[i]; }
  int end(int i) const { return end_[i]; }
  /// The highest index among particle i's neighbours, which tells the groups that it can see.
  int last_neighbour(int i) const { return last_[i]; }
  int ghost_begin(int i) const { return ghost_begin_[i]; }
  int ghost_end(int i) const { return ghost_begin_[i + 1]; }

  /// Length of all rows with their padding: that of arrays with an entry a pair. There is padding up to
  /// `padded_end(i)`.
  int pairs() const { return begin_.back(); }
  int padded_end(int i) const { return begin_[i + 1]; }
  simd::PairRows pair_rows() const { return {rows(), begin_.data(), begin_.data() + 1, j.data()}; }
  const int* row_begins() const { return begin_.data(); }

  double radius() const { return radius_; }
  double near_radius() const { return near_radius_; }
  double period_x() const { return grid_.x.period(); }
  double period_y() const { return grid_.y.period(); }
  int longest_row() const { return longest_row_; }

  std::vector<int> j;                              ///< [pairs] the neighbour
  std::vector<float> dx, dy, r;                    ///< [pairs] its relative position and distance
  std::vector<int> ghost;                          ///< [ghost pairs]
  std::vector<float> ghost_dx, ghost_dy, ghost_r;  ///< [ghost pairs]

 private:
  void append_row(int i, float x, float y);
  void append_ghosts(float x, float y);

  double radius_;
  double near_radius_;
  BinGrid grid_;
  ParticleSorter sorter_;
  Bins carriers_, ghosts_;  ///< of a velocity, and of none
  int longest_row_ = 0;
  std::vector<int> begin_{0}, end_, near_end_, last_, ghost_begin_{0};
  Surroundings carriers_around_, ghosts_around_;  ///< of one bin
  std::vector<unsigned char> sets_;               ///< scratch of the search
};

}  // namespace rouleau::particles
