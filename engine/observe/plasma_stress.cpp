#include "engine/observe/plasma_stress.h"

#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace rouleau::observe {

namespace {

// Farther behind a node's tangent than this, in spacings, a particle is beyond the opposite side of the cell.
constexpr double depth = 1;
// Of the normal equations with a diagonal of ones: below it they do not carry all terms.
constexpr double least_pivot = 1e-3;

/// Of a velocity: x0 = du/dx, x1 = du/dy, y0 = dv/dx, y1 = dv/dy.
using VelocityGradient = Eigen::Matrix2d;

/// The fit of a polynomial in the basis {X, Y} or {X, Y, X^2, XY, Y^2}, whose value at the node is given.
template <int Terms>
class Fit {
 public:
  using Basis = Eigen::Matrix<double, Terms, 1>;

  void add(double weight, const Basis& basis, double du, double dv) {
    normal_ += weight * basis * basis.transpose();
    right_.col(0) += weight * du * basis;
    right_.col(1) += weight * dv * basis;
  }

  std::optional<VelocityGradient> gradient() const {
    if (normal_.diagonal().minCoeff() <= 0) return std::nullopt;
    const Basis scale = normal_.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LDLT<Eigen::Matrix<double, Terms, Terms>> factor(scale.asDiagonal() * normal_ *
                                                                  scale.asDiagonal());
    if (factor.vectorD().minCoeff() < least_pivot) return std::nullopt;
    const Eigen::Matrix<double, Terms, 2> terms =
        scale.asDiagonal() * factor.solve(scale.asDiagonal() * right_);
    return terms.template topRows<2>().transpose();
  }

 private:
  Eigen::Matrix<double, Terms, Terms> normal_ = Eigen::Matrix<double, Terms, Terms>::Zero();
  Eigen::Matrix<double, Terms, 2> right_ = Eigen::Matrix<double, Terms, 2>::Zero();
};

/// On the outside of a membrane, by the fits of velocities to its nodes and to what is not inside a cell.
std::optional<VelocityGradient> outer_gradient(const effects::State& state, int node, double nx, double ny) {
  const auto& particles = state.particles;
  const auto& list = state.neighbours;
  Fit<5> quadratic;
  Fit<2> linear;
  for (int k = list.begin(node); k < list.end(node); ++k) {
    const int j = list.j[k];
    if (j >= particles.membrane_end() && particles.cell[j] >= 0) continue;
    const double dx = list.dx[k], dy = list.dy[k];
    if (dx * nx + dy * ny < -depth * state.spacing) continue;
    const double q = 1 - list.r[k] / state.radius, weight = q * q;
    const double x = dx / state.radius, y = dy / state.radius;
    const double du = particles.u[j] - particles.u[node], dv = particles.v[j] - particles.v[node];
    quadratic.add(weight, Fit<5>::Basis{{x, y, x * x, x * y, y * y}}, du, dv);
    linear.add(weight, Fit<2>::Basis{{x, y}}, du, dv);
  }
  auto gradient = quadratic.gradient();
  if (!gradient) gradient = linear.gradient();
  if (gradient) *gradient /= state.radius;
  return gradient;
}

}  // namespace

double scalar_shear_stress(const effects::State& state, const effects::CellState& cell) {
  const cells::Ring ring = state.ring(cell);
  double sum = 0, length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t before = ring.previous(i), after = ring.next(i);
    const double tx = ring.x[after] - ring.x[before], ty = ring.y[after] - ring.y[before];
    const double chord = std::hypot(tx, ty);
    const auto gradient =
        outer_gradient(state, cell.first_node + static_cast<int>(i), ty / chord, -tx / chord);
    if (!gradient) continue;
    const Eigen::Matrix2d strain_rate = 0.5 * (*gradient + gradient->transpose());
    sum += chord * state.viscosity * std::sqrt(2.0) * strain_rate.norm();
    length += chord;
  }
  return length > 0 ? sum / length : 0;
}

}  // namespace rouleau::observe
