#include "engine/linear/two_level_cg.h"

#include <cmath>
#include <numeric>

namespace rouleau::linear {

namespace {

/// Piecewise-constant corrections fall short of the smooth error by about this factor.
constexpr double over_correction = 1.5;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void TwoLevelCg::prepare(const SparseRows& matrix, const Aggregates& aggregates, Constants constants) {
  matrix_ = &matrix;
  aggregates_ = &aggregates;
  constants_ = constants;
  const int n = matrix.rows();
  inverse_diagonal_.resize(n);
  for (int i = 0; i < n; ++i) inverse_diagonal_[i] = 1 / matrix.diagonal[i];
  prepare_coarse();
}

void TwoLevelCg::prepare_coarse() {
  const SparseRows& matrix = *matrix_;
  const int* aggregate = aggregates_->of.data();
  coarse_.reset(*aggregates_);
  for (int i = 0; i < matrix.rows(); ++i) {
    const int a = aggregate[i];
    coarse_.add(a, a, matrix.diagonal[i]);
    for (int k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
      coarse_.add(a, aggregate[matrix.column[k]], static_cast<double>(matrix.value[k]));
    }
  }
  coarse_.factor(constants_ == Constants::ignored);
}

void TwoLevelCg::centre(std::span<double> vector) const {
  if (constants_ == Constants::seen || vector.empty()) return;
  const double mean = std::accumulate(vector.begin(), vector.end(), 0.0) / static_cast<double>(vector.size());
  for (double& value : vector) value -= mean;
}

double TwoLevelCg::precondition() {
  const int n = matrix_->rows();
  const double* coarse = coarse_.correct(std::span<const double>(r_)).data();
  const int* aggregate = aggregates_->of.data();
  for (int i = 0; i < n; ++i) {
    z_[i] = r_[i] * inverse_diagonal_[i] + over_correction * coarse[aggregate[i]];
  }
  centre(z_);
  return dot(r_, z_);
}

Solve TwoLevelCg::solve(std::span<const double> b, std::span<double> x, double tolerance,
                        int max_iterations) {
  const int n = matrix_->rows();
  for (auto* vector : {&r_, &z_, &p_, &q_}) vector->resize(n);
  r_.assign(b.begin(), b.end());
  centre(r_);
  const double goal = tolerance * std::sqrt(dot(r_, r_));
  matrix_->times(x.data(), q_.data());
  for (int i = 0; i < n; ++i) r_[i] -= q_[i];
  centre(r_);
  double norm2 = dot(r_, r_);
  Solve result;
  double rz = precondition();
  p_ = z_;
  for (; result.iterations < max_iterations; ++result.iterations) {
    if (std::sqrt(norm2) <= goal) break;
    matrix_->times(p_.data(), q_.data());
    const double alpha = rz / dot(p_, q_);
    double *r = r_.data(), *p = p_.data(), *q = q_.data(), *out = x.data();
    norm2 = 0;
#pragma omp simd reduction(+ : norm2)
    for (int i = 0; i < n; ++i) {
      out[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      norm2 += r[i] * r[i];
    }
    if (!std::isfinite(norm2)) break;
    const double next_rz = precondition();
    const double beta = next_rz / rz;
    rz = next_rz;
    const double* z = z_.data();
#pragma omp simd
    for (int i = 0; i < n; ++i) p[i] = z[i] + beta * p[i];
  }
  centre(x);
  result.residual = std::sqrt(norm2);
  result.goal = goal;
  result.converged = result.residual <= goal;
  return result;
}

}  // namespace rouleau::linear
