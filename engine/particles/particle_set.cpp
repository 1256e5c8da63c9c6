#include "engine/particles/particle_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::particles {

namespace {

template <class T>
void permute(std::vector<T>& values, const std::vector<int>& order) {
  std::vector<T> sorted(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[static_cast<std::size_t>(order[k])];
  values.swap(sorted);
}

/// Number of a bin, from 0 to 2^24 - 1 with the origin in the middle; whatever is beyond, and what is not a
/// number, goes to the rim.
std::int64_t bin_number(double at) {
  constexpr double middle = 1 << 23;
  const double shifted = std::floor(at) + middle;
  return shifted > 0 ? static_cast<std::int64_t>(std::min(shifted, 2 * middle - 1)) : 0;
}

}  // namespace

int ParticleSet::add(Group g, double px, double py, int of_cell) {
  x.push_back(px);
  y.push_back(py);
  for (auto* field : {&u, &v, &p, &du, &dv, &phi}) field->push_back(0);
  cell.push_back(of_cell);
  id.push_back(next_id_++);
  group.push_back(g);
  return size() - 1;
}

void sort_particles(ParticleSet& particles, double bin) {
  const int n = particles.size();
  std::vector<std::int64_t> key(static_cast<std::size_t>(n));
  particles.first_.fill(0);
  for (int i = 0; i < n; ++i) {
    const Group g = particles.group[i];
    std::int64_t k = static_cast<std::int64_t>(g) << 56;
    if (g == Group::fluid) {
      k += (bin_number(particles.x[i] / bin) << 24) + bin_number(particles.y[i] / bin);
    }
    key[i] = k;
    if (g != Group::dead) ++particles.first_[static_cast<std::size_t>(g) + 1];
  }
  std::partial_sum(particles.first_.begin(), particles.first_.end(), particles.first_.begin());
  const int alive = particles.first(Group::dead);

  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key[a] < key[b]; });
  order.resize(static_cast<std::size_t>(alive));

  for (auto* field : {&particles.x, &particles.y, &particles.u, &particles.v, &particles.p, &particles.du,
                      &particles.dv, &particles.phi}) {
    permute(*field, order);
  }
  permute(particles.cell, order);
  permute(particles.id, order);
  permute(particles.group, order);
}

}  // namespace rouleau::particles
