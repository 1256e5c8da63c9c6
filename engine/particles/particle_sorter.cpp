#include "engine/particles/particle_sorter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::particles {

template <class T>
void ParticleSorter::permute(std::vector<T>& values, std::vector<T>& sorted) const {
  sorted.resize(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) sorted[k] = values[static_cast<std::size_t>(order_[k])];
  values.swap(sorted);
}

void ParticleSorter::sort(ParticleSet& particles, const BinGrid& grid) {
  const int n = particles.size();
  // One key for each group but the fluid's, which has one for each bin.
  constexpr int fluid = static_cast<int>(Group::fluid);
  const int bins = grid.bins();
  const auto key_of_group = [&](Group g) {
    const int number = static_cast<int>(g);
    return number <= fluid ? number : number + bins - 1;
  };
  begin_.assign(static_cast<std::size_t>(key_of_group(Group::dead)) + 2, 0);
  key_.resize(n);
  for (int i = 0; i < n; ++i) {
    const Group g = particles.group[i];
    key_[i] = key_of_group(g) + (g == Group::fluid ? grid.bin(particles.x[i], particles.y[i]) : 0);
    ++begin_[key_[i] + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  particles.first_.fill(0);
  for (int g = 0; g <= static_cast<int>(Group::dead); ++g) {
    particles.first_[g] = begin_[key_of_group(static_cast<Group>(g))];
  }
  order_.resize(n);
  for (int i = 0; i < n; ++i) order_[begin_[key_[i]]++] = i;
  order_.resize(particles.first(Group::dead));

  for (auto* field : {&particles.x, &particles.y, &particles.u, &particles.v, &particles.p, &particles.du,
                      &particles.dv, &particles.phi}) {
    permute(*field, doubles_);
  }
  permute(particles.cell, cells_);
  permute(particles.id, ids_);
  permute(particles.group, groups_);
}

void sort_particles(ParticleSet& particles, double bin) {
  constexpr double most_bins = 2000;
  const auto axis = [&](const std::vector<double>& at) {
    double low = 0, high = 0;
    bool any = false;
    for (int i = 0; i < particles.size(); ++i) {
      if (particles.group[i] != Group::fluid || !(std::abs(at[i]) < most_bins * bin)) continue;
      low = any ? std::min(low, at[i]) : at[i];
      high = any ? std::max(high, at[i]) : at[i];
      any = true;
    }
    return BinAxis(std::floor(low / bin) * bin, high, 2 * bin, 0);
  };
  ParticleSorter().sort(particles, {axis(particles.x), axis(particles.y)});
}

}  // namespace rouleau::particles
