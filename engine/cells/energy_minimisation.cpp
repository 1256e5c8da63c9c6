#include "engine/cells/energy_minimisation.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/bending.h"
#include "engine/cells/energy_hessian.h"
#include "engine/cells/ring.h"
#include "engine/cells/stretch.h"

namespace rouleau::cells {
namespace {

struct Coordinates {
  explicit Coordinates(const MirroredRing::Nodes& nodes)
      : x(nodes.row(0).begin(), nodes.row(0).end()), y(nodes.row(1).begin(), nodes.row(1).end()) {}
  Ring ring() const { return {x, y}; }

  std::vector<double> x, y;
};

}  // namespace

EnergyMinimisation::EnergyMinimisation(const Material& material, double area, const Nodes& start)
    : ring_(static_cast<int>(start.cols())),
      material_(material),
      area_(area),
      free_(at_area(ring_.restrict(start))),
      energy_(energy(free_)),
      stiffest_(1.0 + 16.0 * material.bend_modulus),
      shift_(0.5 * stiffest_) {}

int EnergyMinimisation::run() {
  constexpr int most_iterations = 500;
  constexpr double longest_step = 0.25;
  constexpr double converged_step = 1e-7;  // convergence is fast by then: what is left is far smaller
  constexpr double rounding = 1e-12;
  // Never 0: nothing else holds the ring against translation along x.
  const double least_shift = 1e-11 * stiffest_, largest_shift = 1e3 * stiffest_;

  for (int iteration = 1; iteration <= most_iterations && shift_ < largest_shift; ++iteration) {
    Eigen::VectorXd step;
    if (!newton_step(step)) {
      shift_ *= 5.0;
      continue;
    }
    const double length = step.cwiseAbs().maxCoeff();
    const bool cut = length > longest_step;
    const Eigen::VectorXd trial = at_area(free_ + (cut ? longest_step / length : 1.0) * step);
    const double trial_energy = energy(trial);
    if (!(trial_energy <= energy_ * (1.0 + rounding))) {
      shift_ *= 5.0;
      continue;
    }
    free_ = trial;
    energy_ = trial_energy;
    if (length < converged_step && shift_ == least_shift) return iteration;
    shift_ = std::max(least_shift, shift_ * (cut ? 0.8 : 0.1));
  }
  return -1;
}

/// Scaled onto the exact area, so that the energy alone tells whether a step was good.
Eigen::VectorXd EnergyMinimisation::at_area(const Eigen::VectorXd& free) const {
  return free * std::sqrt(area_ / area(Coordinates(ring_.expand(free)).ring()));
}

double EnergyMinimisation::energy(const Eigen::VectorXd& free) const {
  const Coordinates at(ring_.expand(free));
  return stretch_energy(at.ring(), material_) + bending_energy(at.ring(), material_);
}

EnergyMinimisation::Nodes EnergyMinimisation::forces() const {
  const Coordinates at(nodes());
  std::vector<double> fx(at.x.size(), 0.0), fy(at.x.size(), 0.0);
  add_stretch_forces(at.ring(), material_, fx, fy);
  add_bending_forces(at.ring(), material_, fx, fy);
  const auto count = static_cast<Eigen::Index>(fx.size());
  Nodes result(2, count);
  result.row(0) = Eigen::Map<Eigen::RowVectorXd>(fx.data(), count);
  result.row(1) = Eigen::Map<Eigen::RowVectorXd>(fy.data(), count);
  return result;
}

EnergyMinimisation::Nodes EnergyMinimisation::area_gradient() const {
  const Nodes at = nodes();
  const Eigen::Index n = at.cols();
  Nodes result(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d chord = at.col((i + 1) % n) - at.col((i + n - 1) % n);
    result.col(i) << chord.y() / 2.0, -chord.x() / 2.0;
  }
  return result;
}

/// Second derivatives of energy - pressure * area, plus the shift.
Eigen::SparseMatrix<double> EnergyMinimisation::lagrangian_hessian(double pressure) const {
  std::vector<Eigen::Triplet<double>> entries;
  const Coordinates at(nodes());
  append_energy_hessian(at.ring(), material_, entries);
  const int n = static_cast<int>(at.x.size());
  for (int i = 0; i < n; ++i) {
    const int x = 2 * i, y = 2 * i + 1, next_x = 2 * ((i + 1) % n), next_y = next_x + 1;
    entries.emplace_back(x, next_y, -pressure / 2.0);
    entries.emplace_back(next_y, x, -pressure / 2.0);
    entries.emplace_back(y, next_x, pressure / 2.0);
    entries.emplace_back(next_x, y, pressure / 2.0);
    entries.emplace_back(x, x, shift_);
    entries.emplace_back(y, y, shift_);
  }
  return ring_.hessian(entries);
}

/// The step that keeps the area to first order; false if the matrix is singular.
bool EnergyMinimisation::newton_step(Eigen::VectorXd& step) {
  const Eigen::VectorXd force = ring_.gradient(forces()), growth = ring_.gradient(area_gradient());
  const double pressure = -force.dot(growth) / growth.squaredNorm();
  const Eigen::SparseMatrix<double> matrix = lagrangian_hessian(pressure);
  if (!analysed_) solver_.analyzePattern(matrix);
  analysed_ = true;
  solver_.factorize(matrix);
  if (solver_.info() != Eigen::Success) return false;

  const Eigen::VectorXd by_force = solver_.solve(force), by_growth = solver_.solve(growth);
  step = by_force - growth.dot(by_force) / growth.dot(by_growth) * by_growth;
  auto x = step(Eigen::seq(0, Eigen::last, 2));
  x.array() -= ring_.expand(step).row(0).mean();
  return step.allFinite();
}

}  // namespace rouleau::cells
