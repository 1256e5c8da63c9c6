#include "engine/particles/neighbour_list.h"

#include <algorithm>
#include <cmath>

namespace rouleau::particles {

NeighbourList::NeighbourList(const Extent& extent, double radius, double near_radius, double period_x,
                             double period_y)
    : radius_(radius),
      near_radius_(near_radius),
      axis_x_(extent.x0, extent.x1, radius, period_x),
      axis_y_(extent.y0, extent.y1, radius, period_y),
      carriers_(axis_x_, axis_y_),
      ghosts_(axis_x_, axis_y_) {}

void NeighbourList::append_row(int i, float x, float y) {
  const auto radius2 = static_cast<float>(radius_ * radius_);
  const auto near2 = static_cast<float>(near_radius_ * near_radius_);
  const Surroundings& around = carriers_around_;
  for (auto* found : {&near_, &far_}) {
    found->id.resize(around.id.size() + 1);
    found->dx.resize(around.id.size() + 1);
    found->dy.resize(around.id.size() + 1);
  }
  int nears = 0, fars = 0;
  // Written always and counted only if wanted: the outcome is too irregular for branches.
  for (int k = 0; k < around.count; ++k) {
    const float ex = around.x[k] - x, ey = around.y[k] - y;
    const float r2 = ex * ex + ey * ey;
    const bool within = (r2 < radius2) & (around.id[k] != i);
    const bool close = r2 < near2;
    near_.id[nears] = far_.id[fars] = around.id[k];
    near_.dx[nears] = far_.dx[fars] = ex;
    near_.dy[nears] = far_.dy[fars] = ey;
    nears += within & close;
    fars += within & !close;
  }
  const auto at = j.size();
  const auto append = [](auto& to, const auto& a, int count_a, const auto& b, int count_b) {
    to.insert(to.end(), a.begin(), a.begin() + count_a);
    to.insert(to.end(), b.begin(), b.begin() + count_b);
  };
  append(j, near_.id, nears, far_.id, fars);
  append(dx, near_.dx, nears, far_.dx, fars);
  append(dy, near_.dy, nears, far_.dy, fars);
  r.resize(j.size());
  for (auto k = at; k < j.size(); ++k) r[k] = std::sqrt(dx[k] * dx[k] + dy[k] * dy[k]);
  near_end_.push_back(begin_.back() + nears);
  begin_.push_back(static_cast<int>(j.size()));
  longest_row_ = std::max(longest_row_, nears + fars);
}

void NeighbourList::append_ghosts(float x, float y) {
  const auto near2 = static_cast<float>(near_radius_ * near_radius_);
  for (int k = 0; k < ghosts_around_.count; ++k) {
    const float ex = ghosts_around_.x[k] - x, ey = ghosts_around_.y[k] - y;
    const float r2 = ex * ex + ey * ey;
    if (r2 >= near2) continue;
    ghost.push_back(ghosts_around_.id[k]);
    ghost_r.push_back(std::sqrt(r2));
  }
  ghost_begin_.push_back(static_cast<int>(ghost.size()));
}

void NeighbourList::build(const ParticleSet& particles, int rows) {
  carriers_.file(particles.x, particles.y, 0, particles.velocity_end());
  ghosts_.file(particles.x, particles.y, particles.velocity_end(), particles.size());
  begin_.assign(1, 0);
  ghost_begin_.assign(1, 0);
  near_end_.clear();
  for (auto* values : {&dx, &dy, &r, &ghost_r}) values->clear();
  j.clear();
  ghost.clear();
  longest_row_ = 0;
  int collected = -1;
  for (int i = 0; i < rows; ++i) {
    // Sorted particles come bin by bin, so what is around a bin is mostly found once.
    const int bin = carriers_.bin(particles.x[i], particles.y[i]);
    if (bin != collected) {
      carriers_.collect(bin, carriers_around_);
      ghosts_.collect(bin, ghosts_around_);
      collected = bin;
    }
    const auto [x, y] = carriers_.relative(particles.x[i], particles.y[i], bin);
    append_row(i, x, y);
    append_ghosts(x, y);
  }
}

}  // namespace rouleau::particles
