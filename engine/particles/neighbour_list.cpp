#include "engine/particles/neighbour_list.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::particles {

namespace {

/// The bin of a coordinate counted in bins; a stray one, and one that is not a number, goes to the rim.
int rim_bound(double at, int bins) {
  return at > 0 ? static_cast<int>(std::min(at, bins - 1.0)) : 0;
}

}  // namespace

NeighbourList::NeighbourList(const Extent& extent, double radius, double near_radius)
    : extent_(extent),
      radius_(radius),
      near_radius_(near_radius),
      bin_(radius / 2),
      columns_(static_cast<int>((extent.x1 - extent.x0) / bin_) + 1),
      rows_(static_cast<int>((extent.y1 - extent.y0) / bin_) + 1) {}

int NeighbourList::column(double x) const {
  return rim_bound((x - extent_.x0) / bin_, columns_);
}

int NeighbourList::row(double y) const {
  return rim_bound((y - extent_.y0) / bin_, rows_);
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

void NeighbourList::append_pairs(const ParticleSet& particles, int i, const int* others, int count) {
  const std::size_t at = j.size();
  j.insert(j.end(), others, others + count);
  for (auto* values : {&dx, &dy, &r}) values->resize(j.size());
  const double* x = particles.x.data();
  const double* y = particles.y.data();
  const double xi = x[i], yi = y[i];
  float* out_x = dx.data() + at;
  float* out_y = dy.data() + at;
  float* out_r = r.data() + at;
#pragma omp simd
  for (int k = 0; k < count; ++k) {
    const auto ex = static_cast<float>(x[others[k]] - xi);
    const auto ey = static_cast<float>(y[others[k]] - yi);
    out_x[k] = ex;
    out_y[k] = ey;
    out_r[k] = std::sqrt(ex * ex + ey * ey);
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

  for (auto* found : {&near_, &far_, &near_ghosts_}) found->resize(particles.x.size() + 1);
  for (int i = 0; i < active; ++i) {
    const double xi = particles.x[i];
    const double yi = particles.y[i];
    const int cx = column(xi);
    const int cy = row(yi);
    int nears = 0, fars = 0, ghosts = 0;
    for (int a = std::max(cx - 2, 0); a <= std::min(cx + 2, columns_ - 1); ++a) {
      const int from = bin_begin_[a * rows_ + std::max(cy - 2, 0)];
      const int to = bin_begin_[a * rows_ + std::min(cy + 2, rows_ - 1) + 1];
      // Written always and counted only if wanted: the outcome is too irregular for branches.
      for (int k = from; k < to; ++k) {
        const double ex = filed_x_[k] - xi;
        const double ey = filed_y_[k] - yi;
        const double r2 = ex * ex + ey * ey;
        const int other = filed_[k];
        const bool ghostly = other >= first_ghost;
        const bool within = r2 < radius2 && other != i;
        const bool close = r2 < near2;
        near_[nears] = other;
        far_[fars] = other;
        near_ghosts_[ghosts] = other;
        nears += within & close & !ghostly;
        fars += within & !close & !ghostly;
        ghosts += within & close & ghostly;
      }
    }
    near_end_.push_back(begin_.back() + nears);
    append_pairs(particles, i, near_.data(), nears);
    append_pairs(particles, i, far_.data(), fars);
    begin_.push_back(static_cast<int>(j.size()));
    longest_row_ = std::max(longest_row_, nears + fars);
    for (int k = 0; k < ghosts; ++k) {
      const int other = near_ghosts_[k];
      ghost.push_back(other);
      ghost_r.push_back(static_cast<float>(std::hypot(particles.x[other] - xi, particles.y[other] - yi)));
    }
    ghost_begin_.push_back(static_cast<int>(ghost.size()));
  }
}

}  // namespace rouleau::particles
