#include "engine/operators/least_squares.h"

#include <array>
#include <cmath>

namespace rouleau::operators {

namespace {

constexpr int terms = 5;
using Coefficients = std::array<double, terms>;

/// The normal matrix of the basis {X, Y, X^2, XY, Y^2}, from its twelve moments.
struct Moments {
  float m20 = 0, m11 = 0, m02 = 0, m30 = 0, m21 = 0, m12 = 0, m03 = 0;
  float m40 = 0, m31 = 0, m22 = 0, m13 = 0, m04 = 0;
};

Moments sum_moments(const float* X, const float* Y, const float* w, int n) {
  float m20 = 0, m11 = 0, m02 = 0, m30 = 0, m21 = 0, m12 = 0, m03 = 0;
  float m40 = 0, m31 = 0, m22 = 0, m13 = 0, m04 = 0;
#pragma omp simd reduction(+ : m20, m11, m02, m30, m21, m12, m03, m40, m31, m22, m13, m04)
  for (int k = 0; k < n; ++k) {
    const float xx = X[k] * X[k], xy = X[k] * Y[k], yy = Y[k] * Y[k];
    const float wxx = w[k] * xx, wxy = w[k] * xy, wyy = w[k] * yy;
    m20 += wxx;
    m11 += wxy;
    m02 += wyy;
    m30 += wxx * X[k];
    m21 += wxx * Y[k];
    m12 += wyy * X[k];
    m03 += wyy * Y[k];
    m40 += wxx * xx;
    m31 += wxx * xy;
    m22 += wxx * yy;
    m13 += wyy * xy;
    m04 += wyy * yy;
  }
  return {m20, m11, m02, m30, m21, m12, m03, m40, m31, m22, m13, m04};
}

/// Cholesky factor of the 5x5 normal matrix.
class NormalMatrix {
 public:
  explicit NormalMatrix(const Moments& m)
      : a_{{{m.m20},
            {m.m11, m.m02},
            {m.m30, m.m21, m.m40},
            {m.m21, m.m12, m.m31, m.m22},
            {m.m12, m.m03, m.m22, m.m13, m.m04}}} {}

  /// Tikhonov damping, light on the linear terms and heavy on the quadratic ones.
  void damp() {
    const double trace = a_[0][0] + a_[1][1] + 1e-3;
    for (int q = 0; q < terms; ++q) a_[q][q] += (q < 2 ? 1e-4 : 0.05) * trace;
  }

  bool factor() {
    for (int i = 0; i < terms; ++i) {
      for (int j = 0; j <= i; ++j) {
        double s = a_[i][j];
        for (int k = 0; k < j; ++k) s -= a_[i][k] * a_[j][k];
        if (i == j) {
          if (!(s > 1e-6)) return false;
          a_[i][i] = std::sqrt(s);
        } else {
          a_[i][j] = s / a_[j][j];
        }
      }
    }
    return true;
  }

  Coefficients solve(Coefficients b) const {
    for (int i = 0; i < terms; ++i) {
      for (int k = 0; k < i; ++k) b[i] -= a_[i][k] * b[k];
      b[i] /= a_[i][i];
    }
    for (int i = terms - 1; i >= 0; --i) {
      for (int k = i + 1; k < terms; ++k) b[i] -= a_[k][i] * b[k];
      b[i] /= a_[i][i];
    }
    return b;
  }

 private:
  std::array<std::array<double, terms>, terms> a_;
};

struct Fit {
  Coefficients dx{}, dy{}, laplacian{};
  bool poor = false;
};

constexpr Coefficients unit_dx{1, 0, 0, 0, 0}, unit_dy{0, 1, 0, 0, 0}, unit_laplacian{0, 0, 2, 0, 2};

Fit fit_velocity(const Moments& moments) {
  NormalMatrix matrix(moments);
  Fit fit;
  if (!matrix.factor()) {
    fit.poor = true;
    matrix = NormalMatrix(moments);
    matrix.damp();
    if (!matrix.factor()) return fit;
  }
  fit.dx = matrix.solve(unit_dx);
  fit.dy = matrix.solve(unit_dy);
  fit.laplacian = matrix.solve(unit_laplacian);
  return fit;
}

Fit fit_pressure(const Moments& moments) {
  NormalMatrix matrix(moments);
  Fit fit;
  if (matrix.factor()) {
    fit.dx = matrix.solve(unit_dx);
    fit.dy = matrix.solve(unit_dy);
    return fit;
  }
  fit.poor = true;
  const double a = moments.m20, b = moments.m11, c = moments.m02;
  const double determinant = a * c - b * b;
  if (determinant < 1e-8) return fit;
  fit.dx = {c / determinant, -b / determinant, 0, 0, 0};
  fit.dy = {-b / determinant, a / determinant, 0, 0, 0};
  return fit;
}

void write_weights(const Coefficients& c, double scale, const float* X, const float* Y, const float* w, int n,
                   float* out) {
  std::array<float, terms> a;
  for (int q = 0; q < terms; ++q) a[q] = static_cast<float>(c[q] * scale);
#pragma omp simd
  for (int k = 0; k < n; ++k) {
    out[k] =
        w[k] * (a[0] * X[k] + a[1] * Y[k] + a[2] * X[k] * X[k] + a[3] * X[k] * Y[k] + a[4] * Y[k] * Y[k]);
  }
}

/// Four sums at once, since each is a chain of dependent additions.
Gradient weighted_sum(const int* j, const float* wx, const float* wy, int n, const double* field,
                      double here) {
  std::array<double, 4> sx{}, sy{};
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    for (int lane = 0; lane < 4; ++lane) {
      const double difference = field[j[k + lane]] - here;
      sx[lane] += wx[k + lane] * difference;
      sy[lane] += wy[k + lane] * difference;
    }
  }
  for (; k < n; ++k) {
    const double difference = field[j[k]] - here;
    sx[0] += wx[k] * difference;
    sy[0] += wy[k] * difference;
  }
  return {(sx[0] + sx[1]) + (sx[2] + sx[3]), (sy[0] + sy[1]) + (sy[2] + sy[3])};
}

}  // namespace

void LeastSquares::build(const particles::ParticleSet& particles, const particles::NeighbourList& list) {
  list_ = &list;
  const std::size_t pairs = list.j.size();
  for (auto* weights : {&dx_, &dy_, &laplacian_, &pressure_dx_, &pressure_dy_}) weights->resize(pairs);
  for (auto* scratch : {&X_, &Y_, &w_}) scratch->resize(list.longest_row());
  poor_rows_ = 0;
  for (int i = 0; i < list.rows(); ++i) fit_row(list, i, particles.pressure_end());
}

void LeastSquares::fit_row(const particles::NeighbourList& list, int i, int pressure_end) {
  const int begin = list.begin(i);
  const int n = list.end(i) - begin;
  // Offsets in units of half the radius keep the moments near one.
  const auto inverse_radius = static_cast<float>(1 / list.radius());
  const float scale = 2 * inverse_radius;
  const float* rdx = list.dx.data() + begin;
  const float* rdy = list.dy.data() + begin;
  const float* rr = list.r.data() + begin;
  const int* j = list.j.data() + begin;
  float* X = X_.data();
  float* Y = Y_.data();
  float* w = w_.data();
  int without_pressure = 0;
#pragma omp simd reduction(+ : without_pressure)
  for (int k = 0; k < n; ++k) {
    const float q = 1 - rr[k] * inverse_radius;
    X[k] = rdx[k] * scale;
    Y[k] = rdy[k] * scale;
    w[k] = q * q;
    without_pressure += j[k] >= pressure_end;
  }

  const Fit velocity = fit_velocity(sum_moments(X, Y, w, n));
  poor_rows_ += velocity.poor;
  write_weights(velocity.dx, scale, X, Y, w, n, dx_.data() + begin);
  write_weights(velocity.dy, scale, X, Y, w, n, dy_.data() + begin);
  write_weights(velocity.laplacian, scale * scale, X, Y, w, n, laplacian_.data() + begin);

  if (without_pressure == 0) {
    for (int k = begin; k < begin + n; ++k) {
      pressure_dx_[k] = dx_[k];
      pressure_dy_[k] = dy_[k];
    }
    return;
  }
  for (int k = 0; k < n; ++k) {
    if (j[k] >= pressure_end) w[k] = 0;
  }
  const Fit pressure = fit_pressure(sum_moments(X, Y, w, n));
  poor_rows_ += pressure.poor;
  write_weights(pressure.dx, scale, X, Y, w, n, pressure_dx_.data() + begin);
  write_weights(pressure.dy, scale, X, Y, w, n, pressure_dy_.data() + begin);
}

Gradient LeastSquares::velocity_gradient(int i, const double* field) const {
  const int begin = list_->begin(i);
  return weighted_sum(list_->j.data() + begin, dx_.data() + begin, dy_.data() + begin, list_->end(i) - begin,
                      field, field[i]);
}

Gradient LeastSquares::pressure_gradient(int i, const double* field) const {
  const int begin = list_->begin(i);
  return weighted_sum(list_->j.data() + begin, pressure_dx_.data() + begin, pressure_dy_.data() + begin,
                      list_->end(i) - begin, field, field[i]);
}

}  // namespace rouleau::operators
