#include "engine/particles/neighbour_list.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::particles {

NeighbourList::NeighbourList(const Extent& extent, double radius, double near_radius)
    : extent_(extent),
      radius_(radius),
      near_radius_(near_radius),
      columns_(static_cast<int>((extent.x1 - extent.x0) / radius) + 1),
      rows_(static_cast<int>((extent.y1 - extent.y0) / radius) + 1) {}

int NeighbourList::column(double x) const {
  const double at = std::clamp((x - extent_.x0) / radius_, 0.0, columns_ - 1.0);
  return static_cast<int>(at);
}

int NeighbourList::row(double y) const {
  const double at = std::clamp((y - extent_.y0) / radius_, 0.0, rows_ - 1.0);
  return static_cast<int>(at);
}

void NeighbourList::file_particles(const ParticleSet& particles) {
  const int n = particles.size();
  bin_begin_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  bin_of_.resize(n);
  filed_.resize(n);
  filed_x_.resize(n);
  filed_y_.resize(n);
  for (int i = 0; i < n; ++i) {
    bin_of_[i] = column(particles.x[i]) * rows_ + row(particles.y[i]);
    ++bin_begin_[bin_of_[i] + 1];
  }
  std::partial_sum(bin_begin_.begin(), bin_begin_.end(), bin_begin_.begin());
  std::vector<int> next(bin_begin_.begin(), bin_begin_.end() - 1);
  for (int i = 0; i < n; ++i) {
    const int at = next[bin_of_[i]]++;
    filed_[at] = i;
    filed_x_[at] = particles.x[i];
    filed_y_[at] = particles.y[i];
  }
}

void NeighbourList::build(const ParticleSet& particles) {
  file_particles(particles);
  const int active = particles.active_end();
  const int first_ghost = particles.velocity_end();
  const double radius2 = radius_ * radius_;
  const double near2 = near_radius_ * near_radius_;
  begin_.assign(1, 0);
  ghost_begin_.assign(1, 0);
  near_end_.clear();
  for (auto* values : {&dx, &dy, &r, &ghost_r}) values->clear();
  j.clear();
  ghost.clear();
  longest_row_ = 0;

  std::vector<int> found, far;
  for (int i = 0; i < active; ++i) {
    found.clear();
    far.clear();
    const double xi = particles.x[i];
    const double yi = particles.y[i];
    const int cx = column(xi);
    const int cy = row(yi);
    for (int a = std::max(cx - 1, 0); a <= std::min(cx + 1, columns_ - 1); ++a) {
      const int from = bin_begin_[a * rows_ + std::max(cy - 1, 0)];
      const int to = bin_begin_[a * rows_ + std::min(cy + 1, rows_ - 1) + 1];
      for (int k = from; k < to; ++k) {
        const double ex = filed_x_[k] - xi;
        const double ey = filed_y_[k] - yi;
        const double r2 = ex * ex + ey * ey;
        if (!(r2 < radius2) || filed_[k] == i) continue;
        if (filed_[k] >= first_ghost) {
          if (r2 < near2) {
            ghost.push_back(filed_[k]);
            ghost_r.push_back(static_cast<float>(std::sqrt(r2)));
          }
        } else {
          (r2 < near2 ? found : far).push_back(filed_[k]);
        }
      }
    }
    near_end_.push_back(begin_.back() + static_cast<int>(found.size()));
    found.insert(found.end(), far.begin(), far.end());
    for (const int other : found) {
      const auto ex = static_cast<float>(particles.x[other] - xi);
      const auto ey = static_cast<float>(particles.y[other] - yi);
      j.push_back(other);
      dx.push_back(ex);
      dy.push_back(ey);
      r.push_back(std::sqrt(ex * ex + ey * ey));
    }
    begin_.push_back(static_cast<int>(j.size()));
    ghost_begin_.push_back(static_cast<int>(ghost.size()));
    longest_row_ = std::max(longest_row_, static_cast<int>(found.size()));
  }
}

}  // namespace rouleau::particles
