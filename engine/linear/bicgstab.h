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

/// BiCGSTAB (van der Vorst 1992) for a system that is already preconditioned, in vectors of `Real`; sums are
/// in double. Keeps its vectors from solve to solve.
template <class Real>
class BiCgStab {
 public:
  /// Solves A x = b from the x given, until the residual's 2-norm is below `tolerance`.
  /// @param apply  apply(in, out): out = A in, both of the length of b
  template <class Apply>
  Solve solve(const Apply& apply, std::span<const Real> b, std::span<Real> x, double tolerance,
              int max_iterations);

 private:
  std::vector<Real> r_, shadow_, p_, v_, s_, t_;
};

template <class Real>
template <class Apply>
Solve BiCgStab<Real>::solve(const Apply& apply, std::span<const Real> b, std::span<Real> x, double tolerance,
                            int max_iterations) {
  const std::size_t n = b.size();
  for (auto* vector : {&r_, &shadow_, &p_, &v_, &s_, &t_}) vector->assign(n, 0);
  const auto product = [](Real first, Real second) {
    return static_cast<double>(first) * static_cast<double>(second);
  };
  apply(std::span<const Real>(x), std::span<Real>(t_));
  double norm2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r_[i] = b[i] - t_[i];
    norm2 += product(r_[i], r_[i]);
  }
  shadow_ = r_;
  double rho = 1, alpha = 1, omega = 1, next_rho = norm2;
  Solve result;
  const Real* shadow = shadow_.data();
  Real *r = r_.data(), *p = p_.data(), *v = v_.data(), *s = s_.data(), *t = t_.data(), *out = x.data();
  for (; result.iterations < max_iterations; ++result.iterations) {
    if (std::sqrt(norm2) <= tolerance) break;
    const double beta = result.iterations ? next_rho / rho * alpha / omega : 0;
    rho = next_rho;
    const Real of_p = static_cast<Real>(beta), of_v = static_cast<Real>(beta * omega);
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + of_p * p[i] - of_v * v[i];
    apply(std::span<const Real>(p_), std::span<Real>(v_));
    double shadow_v = 0;
#pragma omp simd reduction(+ : shadow_v)
    for (std::size_t i = 0; i < n; ++i) shadow_v += product(shadow[i], v[i]);
    alpha = rho / shadow_v;
    const Real along_p = static_cast<Real>(alpha);
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) s[i] = r[i] - along_p * v[i];
    apply(std::span<const Real>(s_), std::span<Real>(t_));
    double ts = 0, tt = 0;
#pragma omp simd reduction(+ : ts, tt)
    for (std::size_t i = 0; i < n; ++i) {
      ts += product(t[i], s[i]);
      tt += product(t[i], t[i]);
    }
    omega = tt > 0 ? ts / tt : 0;
    const Real along_s = static_cast<Real>(omega);
    norm2 = 0;
    next_rho = 0;
#pragma omp simd reduction(+ : norm2, next_rho)
    for (std::size_t i = 0; i < n; ++i) {
      out[i] += along_p * p[i] + along_s * s[i];
      r[i] = s[i] - along_s * t[i];
      norm2 += product(r[i], r[i]);
      next_rho += product(r[i], shadow[i]);
    }
    if (!std::isfinite(norm2)) break;
  }
  result.residual = std::sqrt(norm2);
  result.goal = tolerance;
  result.converged = result.residual <= tolerance;
  return result;
}

}  // namespace rouleau::linear
