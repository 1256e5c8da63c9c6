#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace rouleau::linear {

/// How a linear solve went.
struct Solve {
  int iterations = 0;
  double residual = 0;  ///< 2-norm at the end
  double goal = 0;      ///< 2-norm asked for
  bool converged = false;
};

/// BiCGSTAB (van der Vorst 1992) for a system whose rows are already scaled by their diagonal. Keeps its
/// vectors from solve to solve.
class BiCgStab {
 public:
  /// Solves A x = b from the x given, until the residual's 2-norm is below `tolerance`.
  /// @param apply  apply(in, out): out = A in, both of the length of b
  template <class Apply>
  Solve solve(const Apply& apply, std::span<const double> b, std::span<double> x, double tolerance,
              int max_iterations);

 private:
  std::vector<double> r_, shadow_, p_, v_, s_, t_;
};

template <class Apply>
Solve BiCgStab::solve(const Apply& apply, std::span<const double> b, std::span<double> x, double tolerance,
                      int max_iterations) {
  const std::size_t n = b.size();
  for (auto* vector : {&r_, &shadow_, &p_, &v_, &s_, &t_}) vector->assign(n, 0);
  apply(x, std::span<double>(t_));
  double norm2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r_[i] = b[i] - t_[i];
    norm2 += r_[i] * r_[i];
  }
  shadow_ = r_;
  double rho = 1, alpha = 1, omega = 1, next_rho = norm2;
  Solve result;
  const double* shadow = shadow_.data();
  double *r = r_.data(), *p = p_.data(), *v = v_.data(), *s = s_.data(), *t = t_.data();
  for (; result.iterations < max_iterations; ++result.iterations) {
    if (std::sqrt(norm2) <= tolerance) break;
    const double beta = result.iterations ? next_rho / rho * alpha / omega : 0;
    rho = next_rho;
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + beta * (p[i] - omega * v[i]);
    apply(std::span<const double>(p_), std::span<double>(v_));
    double shadow_v = 0;
#pragma omp simd reduction(+ : shadow_v)
    for (std::size_t i = 0; i < n; ++i) shadow_v += shadow[i] * v[i];
    alpha = rho / shadow_v;
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) s[i] = r[i] - alpha * v[i];
    apply(std::span<const double>(s_), std::span<double>(t_));
    double ts = 0, tt = 0;
#pragma omp simd reduction(+ : ts, tt)
    for (std::size_t i = 0; i < n; ++i) {
      ts += t[i] * s[i];
      tt += t[i] * t[i];
    }
    omega = tt > 0 ? ts / tt : 0;
    norm2 = 0;
    next_rho = 0;
    double* out = x.data();
#pragma omp simd reduction(+ : norm2, next_rho)
    for (std::size_t i = 0; i < n; ++i) {
      out[i] += alpha * p[i] + omega * s[i];
      r[i] = s[i] - omega * t[i];
      norm2 += r[i] * r[i];
      next_rho += r[i] * shadow[i];
    }
    if (!std::isfinite(norm2)) break;
  }
  result.residual = std::sqrt(norm2);
  result.goal = tolerance;
  result.converged = result.residual <= tolerance;
  return result;
}

}  // namespace rouleau::linear
