#include "engine/linear/two_level_cg.h"

#include <cmath>

namespace rouleau::linear {

namespace {

/// Piecewise-constant corrections fall short of the smooth error by about this factor.
constexpr double over_correction = 1.5;

}  // namespace

void TwoLevelCg::prepare(const SparseRows& matrix, std::span<const int> aggregate, int aggregates) {
  aggregate_ = aggregate;
  std::vector<double> diagonal(static_cast<std::size_t>(aggregates), 0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < matrix.rows(); ++i) {
    const int a = aggregate[i];
    double kept = matrix.diagonal[i];
    for (int k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
      const int b = aggregate[matrix.column[k]];
      if (b == a) {
        kept += matrix.value[k];
      } else if (b < a) {
        entries.emplace_back(a, b, matrix.value[k]);
      }
    }
    diagonal[a] += kept;
  }
  for (int a = 0; a < aggregates; ++a) {
    // An aggregate that lost all its particles stands alone with a harmless diagonal.
    entries.emplace_back(a, a, diagonal[a] > 0 ? diagonal[a] : 1.0);
  }
  Eigen::SparseMatrix<double> coarse(aggregates, aggregates);
  coarse.setFromTriplets(entries.begin(), entries.end());
  coarse_.compute(coarse);
  coarse_usable_ = coarse_.info() == Eigen::Success;
  coarse_r_.resize(aggregates);
}

double TwoLevelCg::precondition(const SparseRows& matrix) {
  const int n = matrix.rows();
  if (coarse_usable_) {
    coarse_r_.setZero();
    for (int i = 0; i < n; ++i) coarse_r_[aggregate_[i]] += r_[i];
    coarse_z_ = over_correction * coarse_.solve(coarse_r_);
    for (int i = 0; i < n; ++i) z_[i] = r_[i] / matrix.diagonal[i] + coarse_z_[aggregate_[i]];
  } else {
    for (int i = 0; i < n; ++i) z_[i] = r_[i] / matrix.diagonal[i];
  }
  double rz = 0;
  for (int i = 0; i < n; ++i) rz += r_[i] * z_[i];
  return rz;
}

Solve TwoLevelCg::solve(const SparseRows& matrix, std::span<const double> b, std::span<double> x,
                        double tolerance, int max_iterations) {
  const int n = matrix.rows();
  for (auto* vector : {&r_, &z_, &p_, &q_}) vector->assign(static_cast<std::size_t>(n), 0);
  double norm_b = 0, norm2 = 0;
  for (int i = 0; i < n; ++i) {
    r_[i] = b[i] - matrix.row_times(i, x.data());
    norm_b += b[i] * b[i];
    norm2 += r_[i] * r_[i];
  }
  const double goal = tolerance * std::sqrt(norm_b);
  Solve result;
  double rz = precondition(matrix);
  p_ = z_;
  double *r = r_.data(), *p = p_.data(), *q = q_.data(), *out = x.data();
  for (; result.iterations < max_iterations; ++result.iterations) {
    if (std::sqrt(norm2) <= goal) break;
    double pq = 0;
    for (int i = 0; i < n; ++i) {
      q[i] = matrix.row_times(i, p);
      pq += p[i] * q[i];
    }
    const double alpha = rz / pq;
    norm2 = 0;
#pragma omp simd reduction(+ : norm2)
    for (int i = 0; i < n; ++i) {
      out[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      norm2 += r[i] * r[i];
    }
    if (!std::isfinite(norm2)) break;
    const double next_rz = precondition(matrix);
    const double beta = next_rz / rz;
    rz = next_rz;
    const double* z = z_.data();
#pragma omp simd
    for (int i = 0; i < n; ++i) p[i] = z[i] + beta * p[i];
  }
  result.residual = std::sqrt(norm2);
  result.goal = goal;
  result.converged = result.residual <= goal;
  return result;
}

}  // namespace rouleau::linear
