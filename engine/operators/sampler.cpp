#include "engine/operators/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace rouleau::operators {

namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;
using Vector = Eigen::Matrix<double, 6, 1>;

// Bins along one direction, however small the radius is against the box.
constexpr int most_bins = 512;
// Smallest pivot of the normal equations over the largest: below it they do not carry a quadratic.
constexpr double least_pivot = 1e-6;

/// Exponents of x and y of the basis {1, X, Y, X^2, XY, Y^2}.
constexpr std::array<std::array<int, 2>, 6> exponents = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// The weights that turn field values into the fit's value at the point: sum of share_i f_i with
/// share_i = w_i (c . basis_i), where c solves N c = e_0. N has 15 different moments.
Vector value_row(const std::vector<SampledParticle>& found) {
  std::array<std::array<double, 5>, 5> moments{};
  for (const SampledParticle& q : found) {
    double wx = q.weight;
    for (int a = 0; a <= 4; ++a) {
      double wxy = wx;
      for (int b = 0; b <= 4 - a; ++b) {
        moments[a][b] += wxy;
        wxy *= q.dy;
      }
      wx *= q.dx;
    }
  }
  Vector row = Vector::Zero();
  if (moments[0][0] <= 0) return row;
  Matrix normal;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      normal(i, j) = moments[exponents[i][0] + exponents[j][0]][exponents[i][1] + exponents[j][1]];
    }
  }
  const Eigen::LDLT<Matrix> factor(normal);
  const Vector pivots = factor.vectorD();
  if (pivots.minCoeff() < least_pivot * pivots.maxCoeff()) {
    row(0) = 1 / moments[0][0];
    return row;
  }
  return factor.solve(Vector::Unit(0));
}

double share(const Vector& row, const SampledParticle& q) {
  return q.weight *
         (row(0) + q.dx * (row(1) + row(3) * q.dx + row(4) * q.dy) + q.dy * (row(2) + row(5) * q.dy));
}

double folded(double at, double period) {
  return period > 0 ? at - period * std::floor(at / period) : at;
}

int bins(double width, double radius) {
  return static_cast<int>(std::clamp(std::floor(width / radius), 1.0, static_cast<double>(most_bins)));
}

}  // namespace

void Sampler::file(const particles::ParticleSet& particles, const SamplingReach& reach,
                   const SamplingBox& box) {
  particles_ = &particles;
  reach_ = reach;
  box_ = box;
  if (reach_.period_x > 0) box_ = {0, box_.y0, reach_.period_x, box_.y1};
  if (reach_.period_y > 0) box_ = {box_.x0, 0, box_.x1, reach_.period_y};
  const double r = reach_.radius;
  box_ = {box_.x0 - r, box_.y0 - r, box_.x1 + r, box_.y1 + r};
  columns_ = bins(box_.x1 - box_.x0, reach_.radius);
  rows_ = bins(box_.y1 - box_.y0, reach_.radius);
  file_particles();
}

int Sampler::column(double x) const {
  return std::clamp(static_cast<int>((x - box_.x0) / (box_.x1 - box_.x0) * columns_), 0, columns_ - 1);
}

int Sampler::row(double y) const {
  return std::clamp(static_cast<int>((y - box_.y0) / (box_.y1 - box_.y0) * rows_), 0, rows_ - 1);
}

void Sampler::file_particles() {
  entries_.clear();
  const int images_x = reach_.period_x > 0 ? 1 : 0, images_y = reach_.period_y > 0 ? 1 : 0;
  for (int i = 0; i < particles_->velocity_end(); ++i) {
    for (int a = -images_x; a <= images_x; ++a) {
      const double x = folded(particles_->x[i], reach_.period_x) + a * reach_.period_x;
      if (!(x > box_.x0 && x < box_.x1)) continue;
      for (int b = -images_y; b <= images_y; ++b) {
        const double y = folded(particles_->y[i], reach_.period_y) + b * reach_.period_y;
        if (y > box_.y0 && y < box_.y1) entries_.push_back({row(y) * columns_ + column(x), i, x, y});
      }
    }
  }
  bin_begin_.assign(static_cast<std::size_t>(columns_ * rows_ + 1), 0);
  for (const Entry& entry : entries_) ++bin_begin_[entry.bin + 1];
  std::partial_sum(bin_begin_.begin(), bin_begin_.end(), bin_begin_.begin());
  filed_.resize(entries_.size());
  filed_x_.resize(entries_.size());
  filed_y_.resize(entries_.size());
  next_.assign(bin_begin_.begin(), bin_begin_.end() - 1);
  for (const Entry& entry : entries_) {
    const int at = next_[entry.bin]++;
    filed_[at] = entry.index;
    filed_x_[at] = entry.x;
    filed_y_[at] = entry.y;
  }
}

void Sampler::find(double x, double y, int end, std::vector<SampledParticle>& found) const {
  found.clear();
  x = folded(x, reach_.period_x);
  y = folded(y, reach_.period_y);
  const double inverse = 1 / reach_.radius;
  const int first_column = column(x - reach_.radius), last_column = column(x + reach_.radius);
  for (int r = row(y - reach_.radius); r <= row(y + reach_.radius); ++r) {
    const int first = bin_begin_[r * columns_ + first_column];
    const int last = bin_begin_[r * columns_ + last_column + 1];
    for (int k = first; k < last; ++k) {
      if (filed_[k] >= end) continue;
      const double dx = (filed_x_[k] - x) * inverse;
      const double dy = (filed_y_[k] - y) * inverse;
      const double r2 = dx * dx + dy * dy;
      if (r2 >= 1) continue;
      const double rest = 1 - std::sqrt(r2);
      found.push_back({filed_[k], dx, dy, rest * rest});
    }
  }
}

Velocity Sampler::velocity(double x, double y) const {
  find(x, y, particles_->velocity_end(), found_);
  const Vector row = value_row(found_);
  Velocity value;
  for (const SampledParticle& q : found_) {
    const double s = share(row, q);
    value.u += s * particles_->u[q.index];
    value.v += s * particles_->v[q.index];
  }
  return value;
}

double Sampler::pressure(double x, double y) const {
  find(x, y, particles_->pressure_end(), found_);
  const Vector row = value_row(found_);
  double value = 0;
  for (const SampledParticle& q : found_) value += share(row, q) * particles_->p[q.index];
  return value;
}

}  // namespace rouleau::operators
