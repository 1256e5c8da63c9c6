#include "engine/linear/two_level_cg.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/unit/engine/linear/dense_matrices.h"

namespace rouleau::linear {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

std::vector<int> aggregates_of(int n, int count) {
  std::vector<int> aggregate;
  for (int i = 0; i < n; ++i) aggregate.push_back(i * count / n);
  return aggregate;
}

Solve solve(const SparseRows& rows, const std::vector<int>& aggregate, int aggregates, const Vector& b,
            Vector& x, double tolerance, int most = 500) {
  TwoLevelCg solver;
  const Aggregates grouping{aggregate, aggregates, aggregates - 1};
  solver.prepare(rows, grouping);
  const auto n = static_cast<std::size_t>(b.size());
  return solver.solve({b.data(), n}, {x.data(), n}, tolerance, most);
}

TEST(TwoLevelCg, AgreesWithADenseSolve) {
  EXPECT_TRUE(rc::check([] {
    std::srand(*rc::gen::arbitrary<unsigned>());
    const int n = *rc::gen::inRange(1, 50);
    const int aggregates = *rc::gen::inRange(1, n + 1);
    const Matrix a = random_symmetric(n, 1);
    const Vector b = Vector::Random(n), exact = a.ldlt().solve(b);
    Vector x = *rc::gen::arbitrary<bool>() ? Vector(Vector::Zero(n)) : Vector(Vector::Random(n));
    const Solve result = solve(sparse(a), aggregates_of(n, aggregates), aggregates, b, x, 1e-10);
    RC_ASSERT(result.converged);
    RC_ASSERT((x - exact).norm() < 1e-8 * (1 + exact.norm()));
  }));
}

TEST(TwoLevelCg, AnEmptyAggregateDoesNoHarm) {
  const Matrix a = random_symmetric(12, 1);
  const Vector b = Vector::Random(12);
  Vector x = Vector::Zero(12);
  EXPECT_TRUE(solve(sparse(a), aggregates_of(12, 3), 7, b, x, 1e-10).converged);
  EXPECT_LT((a * x - b).norm(), 1e-8);
}

TEST(TwoLevelCg, ZeroRightHandSideFromZeroIsZero) {
  const SparseRows rows = sparse(random_symmetric(10, 1));
  Vector x = Vector::Zero(10);
  const Solve result = solve(rows, aggregates_of(10, 3), 3, Vector::Zero(10), x, 1e-8);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(x.norm(), 0);
}

TEST(TwoLevelCg, SaysWhenItRanOutOfIterations) {
  const SparseRows rows = sparse(random_symmetric(40, 0.01));
  Vector x = Vector::Zero(40);
  const Solve result = solve(rows, aggregates_of(40, 4), 4, Vector::Random(40), x, 1e-12, 3);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 3);
}

TEST(TwoLevelCg, OnlyClaimsWhatItSolvedWhenTheMatrixIsIndefinite) {
  EXPECT_TRUE(rc::check([] {
    std::srand(*rc::gen::arbitrary<unsigned>());
    const int n = *rc::gen::inRange(2, 30);
    const Matrix a = random_symmetric(n, -1);
    const Vector b = Vector::Random(n);
    Vector x = Vector::Zero(n);
    const Solve result = solve(sparse(a), aggregates_of(n, 2), 2, b, x, 1e-6, 300);
    RC_ASSERT(result.iterations <= 300);
    if (result.converged) RC_ASSERT((a * x - b).norm() < 1e-3 * b.norm());
  }));
}

TEST(TwoLevelCg, NeverClaimsToHaveSolvedASingularSystem) {
  Matrix a = Matrix::Identity(8, 8);
  a(3, 3) = 0;
  const Vector b = Vector::Ones(8);
  Vector x = Vector::Zero(8);
  EXPECT_FALSE(solve(sparse(a), aggregates_of(8, 2), 2, b, x, 1e-8).converged);
  x = Vector::Zero(8);
  EXPECT_FALSE(solve(sparse(Matrix::Zero(8, 8)), aggregates_of(8, 2), 2, b, x, 1e-8).converged);
}

TEST(TwoLevelCg, NeverClaimsToHaveSolvedWhatIsNotANumber) {
  Vector b = Vector::Ones(6), x = Vector::Zero(6);
  b[1] = std::numeric_limits<double>::quiet_NaN();
  const Solve result = solve(sparse(random_symmetric(6, 1)), aggregates_of(6, 2), 2, b, x, 1e-8);
  EXPECT_FALSE(result.converged);
  EXPECT_LE(result.iterations, 1);
}

/// The matrix of a closed vessel: every row adds up to 0.
SparseRows closed_box(int side) {
  SparseRows rows;
  rows.clear();
  for (int a = 0; a < side; ++a) {
    for (int b = 0; b < side; ++b) {
      int count = 0;
      for (const auto& [c, d] : {std::pair{a - 1, b}, {a, b - 1}, {a, b + 1}, {a + 1, b}}) {
        if (c < 0 || c >= side || d < 0 || d >= side) continue;
        rows.add(c * side + d, -1);
        ++count;
      }
      rows.end_row(count);
    }
  }
  return rows;
}

TEST(TwoLevelCg, SolvesAClosedBoxButForAConstant) {
  constexpr int side = 24;
  const SparseRows rows = closed_box(side);
  std::vector<double> x, y;
  for (int i = 0; i < rows.rows(); ++i) {
    x.push_back(i / side);
    y.push_back(i % side);
  }
  GridAggregates grid(5, 0, 0);
  TwoLevelCg solver;
  solver.prepare(rows, grid.build(x, y), Constants::ignored);
  std::srand(5);
  // A mean that no solution can have, as leaks and rounding make it.
  const Vector b = Vector::Random(rows.rows()) + Vector::Constant(rows.rows(), 0.7);
  Vector found = Vector::Constant(rows.rows(), 1e6);
  const auto n = static_cast<std::size_t>(rows.rows());
  const Solve result = solver.solve({b.data(), n}, {found.data(), n}, 1e-10, 500);
  ASSERT_TRUE(result.converged);
  EXPECT_LT(result.iterations, 100);
  EXPECT_NEAR(found.mean(), 0, 1e-9);
  const double mean = b.mean();
  Vector product(rows.rows());
  rows.times(found.data(), product.data());
  for (int i = 0; i < rows.rows(); ++i) ASSERT_NEAR(product[i], b[i] - mean, 1e-8);
}

/// Five-point Laplacian of a strip ten nodes wide, held at its far end alone, as a vessel's pressure is.
int strip_iterations(int length, int block) {
  constexpr int width = 10;
  SparseRows rows;
  rows.clear();
  std::vector<int> aggregate;
  const int blocks_across = width / block;
  for (int a = 0; a < length; ++a) {
    for (int b = 0; b < width; ++b) {
      int count = a == length - 1;  // the held neighbour beyond the end
      const auto couple = [&](int c, int d) {
        if (c < 0 || c >= length || d < 0 || d >= width) return;
        rows.add(c * width + d, -1);
        ++count;
      };
      couple(a - 1, b);
      couple(a, b - 1);
      couple(a, b + 1);
      couple(a + 1, b);
      rows.end_row(count);
      aggregate.push_back(a / block * blocks_across + b / block);
    }
  }
  const int n = rows.rows();
  std::srand(3);
  const Vector b = Vector::Random(n);
  Vector x = Vector::Zero(n);
  const Solve result = solve(rows, aggregate, aggregate.back() + 1, b, x, 1e-6, 5000);
  EXPECT_TRUE(result.converged);
  return result.iterations;
}

TEST(TwoLevelCg, IterationsHardlyGrowWithTheLengthOfTheVessel) {
  const int short_vessel = strip_iterations(40, 5), long_vessel = strip_iterations(640, 5);
  EXPECT_LE(long_vessel, 1.5 * short_vessel) << short_vessel << " and " << long_vessel;
}

TEST(TwoLevelCg, WithoutACoarseSpaceToSpeakOfTheyWouldGrow) {
  // One aggregate ten nodes wide and 640 long is hardly a coarse space: what the test above could not see.
  const int coarse = strip_iterations(640, 5);
  SCOPED_TRACE(coarse);
  EXPECT_GT(strip_iterations(640, 10), coarse);
}

}  // namespace
}  // namespace rouleau::linear
