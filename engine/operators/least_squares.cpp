#include "engine/operators/least_squares.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/operators/poor_fit.h"
#include "engine/simd/kernels.h"

namespace rouleau::operators {

namespace {

using particles::NeighbourList;

constexpr int everybody = std::numeric_limits<int>::max();

simd::RowChoice choice(const std::vector<int>& rows, const int* weight_begin) {
  return {rows.data(), static_cast<int>(rows.size()), weight_begin};
}

FitRow row_of(const NeighbourList& list, int i, int j_end) {
  const int begin = list.begin(i);
  return {&list.dx[begin],
          &list.dy[begin],
          &list.r[begin],
          &list.j[begin],
          list.padded_end(i) - begin,
          static_cast<float>(list.radius()),
          j_end};
}

Gradient weighted_sum(const NeighbourList& list, int i, const float* wx, const float* wy,
                      const double* field) {
  const int* j = &list.j[list.begin(i)];
  const int n = list.end(i) - list.begin(i);
  Gradient sum;
  for (int k = 0; k < n; ++k) {
    const double difference = field[j[k]] - field[i];
    sum.x += wx[k] * difference;
    sum.y += wy[k] * difference;
  }
  return sum;
}

}  // namespace

void LeastSquares::build(const particles::ParticleSet& particles, const NeighbourList& list) {
  list_ = &list;
  poor_rows_ = 0;
  place_pressure_rows(particles.pressure_end());
  fit_velocities();
  fit_pressures(particles.pressure_end());
}

void LeastSquares::place_pressure_rows(int pressure_end) {
  const int rows = list_->rows();
  all_rows_.resize(rows);
  std::iota(all_rows_.begin(), all_rows_.end(), 0);
  pressure_begin_.assign(list_->row_begins(), list_->row_begins() + rows);
  walled_rows_.clear();
  open_rows_.clear();
  int at = list_->pairs();
  for (int i = 0; i < rows; ++i) {
    if (list_->last_neighbour(i) < pressure_end) {
      open_rows_.push_back(i);
      continue;
    }
    walled_rows_.push_back(i);
    pressure_begin_[i] = at;
    at += list_->padded_end(i) - list_->begin(i);
  }
  // One more, so that an empty last row has a place, too.
  dx_.resize(at + 1);
  dy_.resize(at + 1);
  laplacian_.resize(list_->pairs() + 1);
}

void LeastSquares::fit_velocities() {
  poor_.resize(all_rows_.size());
  fit({.choice = choice(open_rows_, list_->row_begins()), .laplacian = laplacian_.data(), .quartic = true});
  // Beside walls a quadratic is nearer to the flow.
  quadratic_rows_ = walled_rows_;
  for (std::size_t k = 0; k < open_rows_.size(); ++k) {
    if (poor_[k]) quadratic_rows_.push_back(open_rows_[k]);
  }
  fit({.choice = choice(quadratic_rows_, list_->row_begins()), .laplacian = laplacian_.data()});
  for (std::size_t k = 0; k < quadratic_rows_.size(); ++k) {
    if (!poor_[k]) continue;
    ++poor_rows_;
    const int i = quadratic_rows_[k];
    const FitRow row = row_of(*list_, i, everybody);
    const FitCoefficients damped = damped_fit(row);
    write_weights(row, damped.dx, 1, &dx_[list_->begin(i)]);
    write_weights(row, damped.dy, 1, &dy_[list_->begin(i)]);
    write_weights(row, damped.laplacian, 2, &laplacian_[list_->begin(i)]);
  }
}

void LeastSquares::fit_pressures(int pressure_end) {
  simd::FitTask task{.choice = choice(walled_rows_, pressure_begin_.data()), .j_end = pressure_end};
  fit(task);
  for (std::size_t k = 0; k < walled_rows_.size(); ++k) {
    if (!poor_[k]) continue;
    ++poor_rows_;
    const int i = walled_rows_[k];
    const FitRow row = row_of(*list_, i, pressure_end);
    const FitCoefficients linear = linear_fit(row);
    write_weights(row, linear.dx, 1, &dx_[pressure_begin_[i]]);
    write_weights(row, linear.dy, 1, &dy_[pressure_begin_[i]]);
  }
}

void LeastSquares::fit(simd::FitTask task) {
  task.radius = static_cast<float>(list_->radius());
  task.dx = dx_.data();
  task.dy = dy_.data();
  task.poor = poor_.data();
  simd::kernels().fit(list_->pair_rows(), {list_->dx.data(), list_->dy.data(), list_->r.data()}, task);
}

void LeastSquares::scale_laplacians(std::span<const int> rows, const std::vector<double>& factor) {
  for (const int i : rows) {
    for (int k = list_->begin(i); k < list_->end(i); ++k) {
      laplacian_[k] *= static_cast<float>(0.5 * (factor[i] + factor[list_->j[k]]));
    }
  }
}

Gradient LeastSquares::velocity_gradient(int i, const double* field) const {
  return weighted_sum(*list_, i, dx(i), dy(i), field);
}

Gradient LeastSquares::pressure_gradient(int i, const double* field) const {
  return weighted_sum(*list_, i, pressure_dx(i), pressure_dy(i), field);
}

void LeastSquares::divergences(const double* uv, std::vector<double>& out) const {
  out.resize(all_rows_.size());
  simd::kernels().divergences(list_->pair_rows(), dx_.data(), dy_.data(), uv, out.data());
}

void LeastSquares::pressure_gradients(const double* p, std::vector<double>& out) const {
  out.resize(2 * all_rows_.size());
  simd::kernels().gradients(list_->pair_rows(), {all_rows_.data(), list_->rows(), pressure_begin_.data()},
                            dx_.data(), dy_.data(), p, out.data());
}

void LeastSquares::field_gradients(const double* fields, const double* p, std::vector<double>& out) {
  out.resize(8 * all_rows_.size());
  simd::kernels().field_gradients(list_->pair_rows(), dx_.data(), dy_.data(), fields, out.data());
  const int walled = static_cast<int>(walled_rows_.size());
  walled_gradients_.resize(2 * walled_rows_.size());
  simd::kernels().gradients(list_->pair_rows(), {walled_rows_.data(), walled, pressure_begin_.data()},
                            dx_.data(), dy_.data(), p, walled_gradients_.data());
  for (int k = 0; k < walled; ++k) {
    double* const of_row = &out[8 * static_cast<std::size_t>(walled_rows_[k])];
    of_row[2] = walled_gradients_[2 * k];
    of_row[6] = walled_gradients_[2 * k + 1];
  }
}

void LeastSquares::velocity_laplacians(const double* uv, std::vector<double>& out,
                                       std::vector<double>& weights) const {
  out.resize(2 * all_rows_.size());
  weights.resize(all_rows_.size());
  simd::kernels().velocity_laplacians(list_->pair_rows(), laplacian_.data(), uv, out.data(), weights.data());
}

void LeastSquares::laplacian_products(const float* uv, float* out) const {
  simd::kernels().velocity_products(list_->pair_rows(), laplacian_.data(), uv, out);
}

void interleave(const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& uv) {
  uv.resize(2 * u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    uv[2 * i] = u[i];
    uv[2 * i + 1] = v[i];
  }
}

}  // namespace rouleau::operators
