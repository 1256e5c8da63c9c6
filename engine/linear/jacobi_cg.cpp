#include "engine/linear/jacobi_cg.h"

#include <cmath>

namespace rouleau::linear {

namespace {

/// By how much the residual that is carried along may be off: where there is no solution it goes astray.
constexpr double drift = 10;

}  // namespace

double JacobiCg::true_residual(const SparseRows& matrix, std::span<const double> b,
                               std::span<const double> x) {
  matrix.times(x.data(), q_.data());
  double norm2 = 0;
  for (std::size_t i = 0; i < b.size(); ++i) norm2 += (b[i] - q_[i]) * (b[i] - q_[i]);
  return std::sqrt(norm2);
}

Solve JacobiCg::solve(const SparseRows& matrix, std::span<const double> b, std::span<double> x,
                      double tolerance, int max_iterations) {
  const int n = matrix.rows();
  for (auto* vector : {&r_, &z_, &p_, &q_}) vector->assign(static_cast<std::size_t>(n), 0);
  double *r = r_.data(), *z = z_.data(), *p = p_.data(), *q = q_.data(), *out = x.data();
  const double* diagonal = matrix.diagonal.data();
  double norm_b = 0, norm2 = 0, rz = 0;
  matrix.times(out, q);
  for (int i = 0; i < n; ++i) {
    r[i] = b[i] - q[i];
    p[i] = r[i] / diagonal[i];
    norm_b += b[i] * b[i];
    norm2 += r[i] * r[i];
    rz += r[i] * p[i];
  }
  Solve result;
  result.goal = tolerance * std::sqrt(norm_b);
  for (; result.iterations < max_iterations; ++result.iterations) {
    if (std::sqrt(norm2) <= result.goal) break;
    matrix.times(p, q);
    double pq = 0;
    for (int i = 0; i < n; ++i) pq += p[i] * q[i];
    const double alpha = rz / pq;
    double next_rz = 0;
    norm2 = 0;
#pragma omp simd reduction(+ : norm2, next_rz)
    for (int i = 0; i < n; ++i) {
      out[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      z[i] = r[i] / diagonal[i];
      norm2 += r[i] * r[i];
      next_rz += r[i] * z[i];
    }
    if (!std::isfinite(norm2)) break;
    const double beta = next_rz / rz;
    rz = next_rz;
#pragma omp simd
    for (int i = 0; i < n; ++i) p[i] = z[i] + beta * p[i];
  }
  result.residual = std::sqrt(norm2);
  result.converged = result.residual <= result.goal && true_residual(matrix, b, x) <= drift * result.goal;
  return result;
}

}  // namespace rouleau::linear
