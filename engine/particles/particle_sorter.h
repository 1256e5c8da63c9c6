#pragma once

#include <cstdint>
#include <vector>

#include "engine/particles/bins.h"
#include "engine/particles/particle_set.h"

namespace rouleau::particles {

/// Puts particles into the order of their groups, the fluid within its group by bins (so that neighbours in
/// space are neighbours in memory), and drops the dead. Particles of one bin, membrane nodes, walls and
/// ghosts keep their order. A counting sort; keeps its memory from time to time.
class ParticleSorter {
 public:
  void sort(ParticleSet& particles, const BinGrid& grid);

 private:
  template <class T>
  void permute(std::vector<T>& values, std::vector<T>& sorted) const;

  std::vector<int> begin_;  ///< of each group, and of each bin of the fluid, in the new order
  std::vector<int> key_, order_;
  std::vector<double> doubles_;
  std::vector<std::int32_t> cells_;
  std::vector<std::int64_t> ids_;
  std::vector<Group> groups_;
};

}  // namespace rouleau::particles
