#include "engine/operators/cross_section.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace rouleau::operators {

namespace {

using particles::ParticleSet;
using Matrix = Eigen::Matrix<double, 6, 6>;
using Vector = Eigen::Matrix<double, 6, 1>;

/// Value at (x, y) of a quadratic fitted to a field on the given particles; a plain weighted mean where they
/// do not carry a quadratic.
double fit(const ParticleSet& particles, const std::vector<int>& candidates, const std::vector<double>& field,
           double x, double y, double radius) {
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
  for (const int i : candidates) {
    const double X = (particles.x[i] - x) / radius;
    const double Y = (particles.y[i] - y) / radius;
    const double r2 = X * X + Y * Y;
    if (r2 >= 1) continue;
    const double w = (1 - std::sqrt(r2)) * (1 - std::sqrt(r2));
    Vector basis;
    basis << 1, X, Y, X * X, X * Y, Y * Y;
    normal.selfadjointView<Eigen::Lower>().rankUpdate(basis, w);
    right += w * field[i] * basis;
  }
  if (normal(0, 0) <= 0) return 0;
  const Eigen::LDLT<Matrix> factor(normal);
  if (factor.rcond() < 1e-9) return right(0) / normal(0, 0);
  return factor.solve(right)(0);
}

/// Simpson's rule over the height.
double integrate(const ParticleSet& particles, const SamplingPlane& plane, const std::vector<double>& field,
                 int end) {
  std::vector<int> near;
  for (int i = 0; i < end; ++i) {
    if (std::abs(particles.x[i] - plane.x) < plane.radius) near.push_back(i);
  }
  double sum = 0;
  for (int k = 0; k <= plane.panels; ++k) {
    const double weight = k == 0 || k == plane.panels ? 1 : k % 2 ? 4 : 2;
    const double y = plane.height * k / plane.panels;
    sum += weight * fit(particles, near, field, plane.x, y, plane.radius);
  }
  return sum * plane.height / (3.0 * plane.panels);
}

}  // namespace

double measure_flux(const ParticleSet& particles, const SamplingPlane& plane) {
  return integrate(particles, plane, particles.u, particles.velocity_end());
}

CrossSection measure(const ParticleSet& particles, const SamplingPlane& plane) {
  return {measure_flux(particles, plane),
          integrate(particles, plane, particles.p, particles.pressure_end()) / plane.height};
}

}  // namespace rouleau::operators
