#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseLU>

#include "engine/cells/material.h"
#include "engine/cells/mirrored_ring.h"

namespace rouleau::cells {

/// Newton's method for the least stretch and bending energy of a mirrored ring at fixed area, with a
/// Levenberg shift. In units of the rest length and the stretch modulus.
class EnergyMinimisation {
 public:
  using Nodes = MirroredRing::Nodes;

  /// `material` has rest length and stretch modulus 1. `start` is mirrored about the x axis and encloses
  /// roughly `area`.
  EnergyMinimisation(const Material& material, double area, const Nodes& start);

  /// Runs to convergence; returns the number of iterations, or -1 if it does not get there.
  int run();

  Nodes nodes() const { return ring_.expand(free_); }

 private:
  Eigen::VectorXd at_area(const Eigen::VectorXd& free) const;
  double energy(const Eigen::VectorXd& free) const;
  Nodes forces() const;
  Nodes area_gradient() const;
  Eigen::SparseMatrix<double> lagrangian_hessian(double pressure) const;
  bool newton_step(Eigen::VectorXd& step);

  MirroredRing ring_;
  Material material_;
  double area_;
  Eigen::VectorXd free_;
  double energy_;
  double stiffest_;  ///< about the largest eigenvalue: of a link, and of a zigzag of hinges
  double shift_;
  bool analysed_ = false;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> solver_;
};

}  // namespace rouleau::cells
