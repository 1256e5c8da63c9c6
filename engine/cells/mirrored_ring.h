#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace rouleau::cells {

/// The coordinates that are free in a ring whose node i is the mirror image of node n - 1 - i about the x
/// axis: those of its first half, x0, y0, x1, y1, … (the y of the middle node of an odd ring has no effect).
/// Besides halving the unknowns this takes away the motion a membrane hardly resists, nodes sliding along it,
/// and turns the closed ring into a chain, whose matrices are banded.
class MirroredRing {
 public:
  using Nodes = Eigen::Matrix2Xd;  ///< all nodes, one a column

  explicit MirroredRing(int nodes) : nodes_(nodes) {}

  Eigen::Index size() const { return 2 * ((nodes_ + 1) / 2); }

  /// The whole ring from its free coordinates.
  Nodes expand(const Eigen::VectorXd& free) const;

  /// The free coordinates of a mirrored ring.
  Eigen::VectorXd restrict(const Nodes& nodes) const;

  /// Derivatives by the free coordinates from derivatives by those of all nodes.
  Eigen::VectorXd gradient(const Nodes& all) const;
  Eigen::SparseMatrix<double> hessian(const std::vector<Eigen::Triplet<double>>& all) const;

 private:
  bool mirrored(int node) const { return 2 * node > nodes_ - 1; }
  int free_node(int node) const { return mirrored(node) ? nodes_ - 1 - node : node; }
  double y_sign(int node) const;

  int nodes_;
};

}  // namespace rouleau::cells
