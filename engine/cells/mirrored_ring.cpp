#include "engine/cells/mirrored_ring.h"

namespace rouleau::cells {

double MirroredRing::y_sign(int node) const {
  if (2 * node == nodes_ - 1) return 0.0;
  return mirrored(node) ? -1.0 : 1.0;
}

MirroredRing::Nodes MirroredRing::expand(const Eigen::VectorXd& free) const {
  Nodes nodes(2, nodes_);
  for (int i = 0; i < nodes_; ++i) {
    nodes.col(i) << free[2 * free_node(i)], y_sign(i) * free[2 * free_node(i) + 1];
  }
  return nodes;
}

Eigen::VectorXd MirroredRing::restrict(const Nodes& nodes) const {
  return nodes.leftCols(size() / 2).reshaped();
}

Eigen::VectorXd MirroredRing::gradient(const Nodes& all) const {
  Eigen::VectorXd free = Eigen::VectorXd::Zero(size());
  for (int i = 0; i < nodes_; ++i) {
    free[2 * free_node(i)] += all(0, i);
    free[2 * free_node(i) + 1] += y_sign(i) * all(1, i);
  }
  return free;
}

Eigen::SparseMatrix<double> MirroredRing::hessian(const std::vector<Eigen::Triplet<double>>& all) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(all.size() + 1);
  const auto sign = [&](int coordinate) { return coordinate % 2 == 0 ? 1.0 : y_sign(coordinate / 2); };
  const auto place = [&](int coordinate) { return 2 * free_node(coordinate / 2) + coordinate % 2; };
  for (const auto& entry : all) {
    entries.emplace_back(place(entry.row()), place(entry.col()),
                         sign(entry.row()) * sign(entry.col()) * entry.value());
  }
  const int last = static_cast<int>(size()) - 1;
  if (nodes_ % 2 == 1) entries.emplace_back(last, last, 1.0);  // keeps the idle y from making it singular
  Eigen::SparseMatrix<double> matrix(size(), size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace rouleau::cells
