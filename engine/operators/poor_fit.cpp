#include "engine/operators/poor_fit.h"

#include <cmath>

namespace rouleau::operators {

namespace {

constexpr int terms = 5;
using Coefficients = std::array<double, terms>;
using Matrix = std::array<Coefficients, terms>;

struct Sample {
  Coefficients basis;
  double weight;
};

Sample sample(const FitRow& row, int k) {
  const double X = 2 * row.dx[k] / row.radius, Y = 2 * row.dy[k] / row.radius;
  const double q = row.j[k] < row.j_end ? 1 - row.r[k] / row.radius : 0;
  return {{X, Y, X * X, X * Y, Y * Y}, q * q};
}

Matrix normal_matrix(const FitRow& row) {
  Matrix matrix{};
  for (int k = 0; k < row.count; ++k) {
    const Sample s = sample(row, k);
    for (int a = 0; a < terms; ++a) {
      for (int b = 0; b < terms; ++b) matrix[a][b] += s.weight * s.basis[a] * s.basis[b];
    }
  }
  return matrix;
}

/// Cholesky, in the lower half.
bool factor(Matrix& a) {
  for (int i = 0; i < terms; ++i) {
    for (int j = 0; j <= i; ++j) {
      double s = a[i][j];
      for (int k = 0; k < j; ++k) s -= a[i][k] * a[j][k];
      if (i == j) {
        if (!(s > 1e-6)) return false;
        a[i][i] = std::sqrt(s);
      } else {
        a[i][j] = s / a[j][j];
      }
    }
  }
  return true;
}

Coefficients solve(const Matrix& a, Coefficients b) {
  for (int i = 0; i < terms; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (int i = terms - 1; i >= 0; --i) {
    for (int k = i + 1; k < terms; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

}  // namespace

FitCoefficients damped_fit(const FitRow& row) {
  Matrix matrix = normal_matrix(row);
  const double trace = matrix[0][0] + matrix[1][1] + 1e-3;
  for (int q = 0; q < terms; ++q) matrix[q][q] += (q < 2 ? 1e-4 : 0.05) * trace;
  if (!factor(matrix)) return {};
  return {solve(matrix, {1, 0, 0, 0, 0}), solve(matrix, {0, 1, 0, 0, 0}), solve(matrix, {0, 0, 2, 0, 2})};
}

FitCoefficients linear_fit(const FitRow& row) {
  const Matrix matrix = normal_matrix(row);
  const double a = matrix[0][0], b = matrix[0][1], c = matrix[1][1];
  const double determinant = a * c - b * b;
  if (!(determinant >= 1e-8)) return {};
  return {{c / determinant, -b / determinant, 0, 0, 0}, {-b / determinant, a / determinant, 0, 0, 0}, {}};
}

void write_weights(const FitRow& row, const Coefficients& coefficients, int order, float* weights) {
  const double scale = std::pow(2.0 / row.radius, order);
  for (int k = 0; k < row.count; ++k) {
    const Sample s = sample(row, k);
    double value = 0;
    for (int q = 0; q < terms; ++q) value += coefficients[q] * s.basis[q];
    weights[k] = static_cast<float>(scale * s.weight * value);
  }
}

}  // namespace rouleau::operators
