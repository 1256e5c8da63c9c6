#pragma once

#include <random>

#include "engine/particles/particle_set.h"

namespace rouleau::operators {

/// A vessel 0 < x < length, 0 < y < 1 full of fluid on a lattice shaken by `jitter` spacings, with nodes on
/// its walls and outlet particles beyond both ends.
inline particles::ParticleSet disordered_vessel(double length, double spacing, double jitter, unsigned seed) {
  using particles::Group;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-jitter * spacing, jitter * spacing);
  particles::ParticleSet set;
  const int across = static_cast<int>(1 / spacing + 0.5), along = static_cast<int>(length / spacing + 0.5);
  for (int a = -5; a <= along + 5; ++a) {
    const double x = a * spacing;
    set.add(Group::wall, x, 0);
    set.add(Group::wall, x, 1);
    for (int b = 1; b < across; ++b) {
      const bool inside = x > 0 && x < length;
      set.add(inside ? Group::fluid : Group::outlet, x + shake(random), b * spacing + shake(random));
    }
  }
  sort_particles(set, spacing);
  return set;
}

}  // namespace rouleau::operators
