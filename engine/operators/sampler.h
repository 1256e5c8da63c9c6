#pragma once

#include <vector>

#include "engine/particles/particle_set.h"

namespace rouleau::operators {

/// How far fits reach, and the directions in which the particles repeat.
struct SamplingReach {
  double radius = 0;    ///< of the fits
  double period_x = 0;  ///< 0: does not repeat
  double period_y = 0;
};

/// Where points to sample lie.
struct SamplingBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Velocity {
  double u = 0, v = 0;
};

/// A particle near a point, or its nearest image where the vessel repeats.
struct SampledParticle {
  int index = 0;
  double dx = 0, dy = 0;  ///< its position relative to the point, over the radius
  double weight = 0;      ///< (1 - r/radius)^2
};

/// Velocity and pressure at any point, by a weighted least-squares fit of a quadratic about it: exact for
/// quadratic fields wherever the neighbourhood carries one, else the weighted mean. Walls are velocity data;
/// pressure is that of the particles that carry one.
class Sampler {
 public:
  /// Files the particles near `box`, once for many points. They must be sorted, and stay as they are while
  /// the sampler is used.
  Sampler(const particles::ParticleSet& particles, const SamplingReach& reach, const SamplingBox& box) {
    file(particles, reach, box);
  }
  /// One that has yet to be given particles.
  Sampler() = default;

  /// As the constructor, in the memory of the last time.
  void file(const particles::ParticleSet& particles, const SamplingReach& reach, const SamplingBox& box);

  /// Both are 0 where there is no particle. Points of a repeating vessel may lie in any image of it, others
  /// must lie in the box.
  Velocity velocity(double x, double y) const;
  double pressure(double x, double y) const;

  /// The particles within the radius of a point, of those before `end` in the set.
  void find(double x, double y, int end, std::vector<SampledParticle>& found) const;

 private:
  struct Entry {
    int bin, index;
    double x, y;
  };

  void file_particles();
  int column(double x) const;
  int row(double y) const;

  const particles::ParticleSet* particles_ = nullptr;
  SamplingReach reach_;
  SamplingBox box_;
  int columns_ = 1, rows_ = 1;
  std::vector<Entry> entries_;
  std::vector<int> bin_begin_, next_;
  std::vector<int> filed_;
  std::vector<double> filed_x_, filed_y_;
  mutable std::vector<SampledParticle> found_;
};

}  // namespace rouleau::operators
