#include "engine/linear/jacobi_cg.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/unit/engine/linear/dense_matrices.h"

namespace rouleau::linear {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Solve solve(const Matrix& a, const Vector& b, Vector& x, double tolerance, int most = 500) {
  const auto n = static_cast<std::size_t>(b.size());
  return JacobiCg().solve(sparse(a), {b.data(), n}, {x.data(), n}, tolerance, most);
}

/// -d2/dx2 between two walls; without the end that is held only its differences count.
Matrix chain(int n, bool held) {
  Matrix a = Matrix::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    if (i > 0) a(i, i - 1) = -1;
    if (i + 1 < n) a(i, i + 1) = -1;
    a(i, i) = (i > 0) + (i + 1 < n) + (held && i + 1 == n);
  }
  return a;
}

TEST(JacobiCg, AgreesWithADenseSolve) {
  EXPECT_TRUE(rc::check([] {
    std::srand(*rc::gen::arbitrary<unsigned>());
    const int n = *rc::gen::inRange(1, 50);
    const Matrix a = random_symmetric(n, 1);
    const Vector b = Vector::Random(n), exact = a.ldlt().solve(b);
    Vector x = *rc::gen::arbitrary<bool>() ? Vector(Vector::Zero(n)) : Vector(Vector::Random(n));
    RC_ASSERT(solve(a, b, x, 1e-10).converged);
    RC_ASSERT((x - exact).norm() < 1e-8 * (1 + exact.norm()));
  }));
}

TEST(JacobiCg, StopsWhereTheResidualIsAsSmallAsAsked) {
  const Matrix a = chain(60, true);
  const Vector b = Vector::Ones(60);
  for (const double tolerance : {1e-2, 1e-6}) {
    Vector x = Vector::Zero(60);
    const Solve result = solve(a, b, x, tolerance);
    EXPECT_TRUE(result.converged);
    EXPECT_LE((a * x - b).norm(), 1.001 * tolerance * b.norm());
    EXPECT_DOUBLE_EQ(result.goal, tolerance * b.norm());
  }
}

TEST(JacobiCg, AChainTakesAsManyIterationsAsItIsLong) {
  for (const int n : {20, 80}) {
    Vector b = Vector::Zero(n), x = Vector::Zero(n);
    b[0] = 1;
    EXPECT_EQ(solve(chain(n, true), b, x, 1e-9).iterations, n);
  }
}

TEST(JacobiCg, SolvesWhatIsFreeButForAConstant) {
  const Matrix a = chain(30, false);
  Vector b = Vector::Random(30), x = Vector::Zero(30);
  b.array() -= b.mean();
  EXPECT_TRUE(solve(a, b, x, 1e-9).converged);
  EXPECT_LT((a * x - b).norm(), 1e-8 * b.norm());
}

TEST(JacobiCg, SaysWhenItRanOutOfIterations) {
  Vector x = Vector::Zero(40);
  const Solve result = solve(chain(40, true), Vector::Ones(40), x, 1e-12, 3);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 3);
}

TEST(JacobiCg, ClaimsNothingOfAnInsolubleSystemOrOneThatIsNotANumber) {
  Vector x = Vector::Zero(30);
  EXPECT_FALSE(solve(chain(30, false), Vector::Ones(30), x, 1e-9).converged);
  Vector b = Vector::Ones(30);
  b[4] = std::numeric_limits<double>::quiet_NaN();
  x.setZero();
  EXPECT_FALSE(solve(chain(30, true), b, x, 1e-9).converged);
}

}  // namespace
}  // namespace rouleau::linear
