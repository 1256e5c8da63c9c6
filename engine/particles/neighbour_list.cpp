#include "engine/particles/neighbour_list.h"

#include <algorithm>
#include <cmath>

namespace rouleau::particles {

NeighbourList::NeighbourList(const Extent& extent, double radius, double near_radius, double period_x,
                             double period_y)
    : radius_(radius),
      near_radius_(near_radius),
      grid_{{extent.x0, extent.x1, radius, period_x}, {extent.y0, extent.y1, radius, period_y}},
      carriers_(grid_),
      ghosts_(grid_) {}

void NeighbourList::append_row(int i, float x, float y) {
  const Surroundings& around = carriers_around_;
  const int at = begin_.back();
  const auto most = static_cast<std::size_t>(around.count + 2 * simd::lanes);
  if (at + most > j.size()) {
    const std::size_t room = 3 * (at + most) / 2;
    j.resize(room);
    for (auto* values : {&dx, &dy, &r}) values->resize(room);
  }
  if (most > sets_.size()) sets_.resize(2 * most);
  const simd::PairCounts found =
      simd::kernels().find_pairs({around.x.data(), around.y.data(), around.id.data(), around.count}, i, x, y,
                                 static_cast<float>(radius_), static_cast<float>(near_radius_),
                                 {&j[at], &dx[at], &dy[at], sets_.data()});
  near_end_.push_back(at + found.near);
  end_.push_back(at + found.all);
  last_.push_back(found.last);
  begin_.push_back(at + simd::padded(found.all));
  longest_row_ = std::max(longest_row_, found.all);
}

void NeighbourList::append_ghosts(float x, float y) {
  const auto near2 = static_cast<float>(near_radius_ * near_radius_);
  for (int k = 0; k < ghosts_around_.count; ++k) {
    const float ex = ghosts_around_.x[k] - x, ey = ghosts_around_.y[k] - y;
    const float r2 = ex * ex + ey * ey;
    if (!(r2 < near2)) continue;
    ghost.push_back(ghosts_around_.id[k]);
    ghost_dx.push_back(ex);
    ghost_dy.push_back(ey);
    ghost_r.push_back(std::sqrt(r2));
  }
  ghost_begin_.push_back(static_cast<int>(ghost.size()));
}

void NeighbourList::build(const ParticleSet& particles, int rows) {
  carriers_.file(particles.x, particles.y, 0, particles.velocity_end());
  ghosts_.file(particles.x, particles.y, particles.velocity_end(), particles.size());
  begin_.assign(1, 0);
  ghost_begin_.assign(1, 0);
  for (auto* ends : {&end_, &near_end_, &last_}) ends->clear();
  ghost.clear();
  for (auto* values : {&ghost_dx, &ghost_dy, &ghost_r}) values->clear();
  longest_row_ = 0;
  int collected = -1;
  for (int i = 0; i < rows; ++i) {
    // Sorted particles come bin by bin, so what is around a bin is mostly found once.
    const int bin = carriers_.bin_of(i);
    if (bin != collected) {
      carriers_.collect(bin, carriers_around_);
      ghosts_.collect(bin, ghosts_around_);
      collected = bin;
    }
    const auto [x, y] = grid_.relative(particles.x[i], particles.y[i], bin);
    append_row(i, x, y);
    append_ghosts(x, y);
  }
  simd::kernels().distances(pair_rows(), end_.data(), dx.data(), dy.data(), static_cast<float>(radius_),
                            r.data());
}

}  // namespace rouleau::particles
