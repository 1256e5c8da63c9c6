#include "engine/cells/stiffness.h"

#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "engine/cells/bending.h"
#include "engine/cells/energy_hessian.h"
#include "engine/cells/stretch.h"
#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {
namespace {

constexpr Material material{3.0, 0.7, 0.5};
constexpr Material no_bending{3.0, 0.0, 0.5}, no_stretch{0.0, 0.7, 0.5};

using Terms = std::vector<Stiffness>;

Terms stretch_terms(Ring ring, int first = 0) {
  Terms terms;
  append_stretch_stiffness(ring, material, first, terms);
  return terms;
}

Terms bending_terms(Ring ring, int first = 0) {
  Terms terms;
  append_bending_stiffness(ring, material, first, terms);
  return terms;
}

/// df/du of a list of terms.
Eigen::MatrixXd assemble(const Terms& terms, std::size_t nodes) {
  const auto size = static_cast<Eigen::Index>(2 * nodes);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (const Stiffness& term : terms) {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    for (std::size_t k = 0; k < 6; ++k) g[2 * term.node[k / 2] + static_cast<int>(k % 2)] += term.g[k];
    matrix -= term.k * g * g.transpose();
  }
  return matrix;
}

/// df/du by central differences.
Eigen::MatrixXd differences(Nodes nodes, const Material& of) {
  const std::size_t n = nodes.x.size();
  const auto forces = [&] {
    std::vector<double> fx(n, 0.0), fy(n, 0.0);
    add_stretch_forces(nodes.ring(), of, fx, fy);
    add_bending_forces(nodes.ring(), of, fx, fy);
    Eigen::VectorXd result(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      result[static_cast<int>(2 * i)] = fx[i];
      result[static_cast<int>(2 * i + 1)] = fy[i];
    }
    return result;
  };
  const double step = 1e-6;
  Eigen::MatrixXd matrix(2 * n, 2 * n);
  for (std::size_t k = 0; k < 2 * n; ++k) {
    double& coordinate = k % 2 == 0 ? nodes.x[k / 2] : nodes.y[k / 2];
    const double middle = coordinate;
    coordinate = middle + step;
    const Eigen::VectorXd above = forces();
    coordinate = middle - step;
    const Eigen::VectorXd below = forces();
    coordinate = middle;
    matrix.col(static_cast<int>(k)) = (above - below) / (2.0 * step);
  }
  return matrix;
}

Nodes regular_polygon(int n, double link) {
  const double radius = link / (2.0 * std::sin(std::numbers::pi / n));
  Nodes nodes;
  for (int i = 0; i < n; ++i) {
    nodes.x.push_back(radius * std::cos(2.0 * std::numbers::pi * i / n));
    nodes.y.push_back(radius * std::sin(2.0 * std::numbers::pi * i / n));
  }
  return nodes;
}

TEST(StretchStiffness, IsTheExactOneOfAStretchedRing) {
  const Nodes nodes = regular_polygon(12, 0.6);
  const Eigen::MatrixXd exact = differences(nodes, no_bending);
  EXPECT_LT((assemble(stretch_terms(nodes.ring()), 12) - exact).norm(), 1e-8 * exact.norm());
}

TEST(StretchStiffness, LeavesOutTheTurningOfCompressedLinks) {
  const Nodes nodes = regular_polygon(12, 0.45);
  const Terms terms = stretch_terms(nodes.ring());
  for (std::size_t i = 0; i < terms.size(); i += 2) {
    EXPECT_DOUBLE_EQ(terms[i].k, material.stretch_modulus / material.rest_length);
    EXPECT_EQ(terms[i + 1].k, 0.0);
  }
}

TEST(BendingStiffness, IsTheExactOneWhereTheRingIsStraight) {
  // A rectangle of 12 by 2 links; the hinges around nodes 5 to 7 of its lower side carry no moment.
  Nodes nodes;
  const auto add_side = [&](int links, double x, double y, double dx, double dy) {
    for (int i = 0; i < links; ++i) {
      nodes.x.push_back(x + i * dx);
      nodes.y.push_back(y + i * dy);
    }
  };
  add_side(12, 0.0, 0.0, 0.5, 0.0);
  add_side(2, 6.0, 0.0, 0.0, 0.5);
  add_side(12, 6.0, 1.0, -0.5, 0.0);
  add_side(2, 0.0, 1.0, 0.0, -0.5);
  const Eigen::MatrixXd exact = differences(nodes, no_stretch).middleCols(10, 6);
  const Eigen::MatrixXd terms = assemble(bending_terms(nodes.ring()), nodes.x.size()).middleCols(10, 6);
  EXPECT_GT(exact.norm(), 1.0);
  EXPECT_LT((terms - exact).norm(), 1e-6 * exact.norm());
}

TEST(Stiffness, NeverFeedsEnergyInAndIgnoresTranslation) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Nodes nodes = random_ring(seed);
    Terms terms = stretch_terms(nodes.ring());
    append_bending_stiffness(nodes.ring(), material, 0, terms);
    ASSERT_EQ(terms.size(), 3 * nodes.x.size());
    for (const Stiffness& term : terms) {
      EXPECT_GE(term.k, 0.0);
      const double size = std::fabs(term.g[0]) + std::fabs(term.g[1]);
      EXPECT_NEAR(term.g[0] + term.g[2] + term.g[4], 0.0, 1e-12 * size);
      EXPECT_NEAR(term.g[1] + term.g[3] + term.g[5], 0.0, 1e-12 * size);
    }
    const Eigen::MatrixXd matrix = assemble(terms, nodes.x.size());
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    EXPECT_LT(values.maxCoeff(), 1e-10 * -values.minCoeff());
  }
}

TEST(Stiffness, OffsetsItsNodes) {
  const Nodes nodes = regular_polygon(8, 0.5);
  const Terms stretch = stretch_terms(nodes.ring(), 100), bending = bending_terms(nodes.ring(), 100);
  EXPECT_EQ(stretch.back().node, (std::array{107, 100, 100}));
  EXPECT_EQ(bending.front().node, (std::array{107, 100, 101}));
}

TEST(EnergyHessian, IsTheDerivativeOfTheForces) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Nodes nodes = random_ring(seed);
    std::vector<Eigen::Triplet<double>> entries;
    append_energy_hessian(nodes.ring(), material, entries);
    const Eigen::MatrixXd expected = -differences(nodes, material);
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(expected.rows(), expected.cols());
    for (const auto& entry : entries) hessian(entry.row(), entry.col()) += entry.value();
    EXPECT_LT((hessian - expected).norm(), 1e-5 * expected.norm()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace rouleau::cells
