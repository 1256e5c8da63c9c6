#include "engine/linear/bicgstab.h"

#include <limits>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rouleau::linear {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Solve solve(const Matrix& a, const Vector& b, Vector& x, double tolerance, int most = 200) {
  BiCgStab<double> solver;
  const auto n = static_cast<std::size_t>(b.size());
  return solver.solve(
      [&](std::span<const double> in, std::span<double> out) {
        Eigen::Map<Vector>(out.data(), b.size()) = a * Eigen::Map<const Vector>(in.data(), b.size());
      },
      {b.data(), n}, {x.data(), n}, tolerance, most);
}

/// Not symmetric, the identity plus something smaller than it.
Matrix random_matrix(int n) {
  Matrix a = Matrix::Random(n, n);
  a *= 0.7 / a.operatorNorm();
  return a + Matrix::Identity(n, n);
}

TEST(BiCgStab, AgreesWithADenseSolve) {
  EXPECT_TRUE(rc::check([] {
    std::srand(*rc::gen::arbitrary<unsigned>());
    const int n = *rc::gen::inRange(1, 60);
    const Matrix a = random_matrix(n);
    const Vector b = Vector::Random(n), exact = a.partialPivLu().solve(b);
    Vector x = *rc::gen::arbitrary<bool>() ? Vector(Vector::Zero(n)) : Vector(Vector::Random(n));
    const Solve result = solve(a, b, x, 1e-11);
    RC_ASSERT(result.converged);
    RC_ASSERT(result.residual <= 1e-11);
    RC_ASSERT((x - exact).norm() < 1e-9);
  }));
}

TEST(BiCgStab, ZeroRightHandSideGivesZero) {
  const Matrix a = random_matrix(20);
  Vector x = Vector::Zero(20);
  Solve result = solve(a, Vector::Zero(20), x, 1e-12);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(x.norm(), 0);
  x = Vector::Random(20);
  result = solve(a, Vector::Zero(20), x, 1e-12);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(x.norm(), 1e-11);
}

TEST(BiCgStab, StartsFromTheGivenVector) {
  const Matrix a = random_matrix(20);
  const Vector b = Vector::Random(20);
  Vector x = a.partialPivLu().solve(b);
  EXPECT_EQ(solve(a, b, x, 1e-10).iterations, 0);
}

TEST(BiCgStab, SaysWhenItRanOutOfIterations) {
  const Matrix a = random_matrix(50);
  Vector x = Vector::Zero(50);
  const Solve result = solve(a, Vector::Random(50), x, 1e-14, 2);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_GT(result.residual, 1e-14);
}

TEST(BiCgStab, NeverClaimsToHaveSolvedASingularSystem) {
  Matrix a = Matrix::Identity(4, 4);
  a(3, 3) = 0;
  Vector b = Vector::Ones(4), x = Vector::Zero(4);
  EXPECT_FALSE(solve(a, b, x, 1e-10).converged);
  x = Vector::Zero(4);
  EXPECT_FALSE(solve(Matrix::Zero(4, 4), b, x, 1e-10).converged);
}

TEST(BiCgStab, NeverClaimsToHaveSolvedWhatIsNotANumber) {
  Vector b = Vector::Ones(4), x = Vector::Zero(4);
  b[2] = std::numeric_limits<double>::quiet_NaN();
  const Solve result = solve(random_matrix(4), b, x, 1e-10);
  EXPECT_FALSE(result.converged);
  EXPECT_LE(result.iterations, 1);
}

}  // namespace
}  // namespace rouleau::linear
