#include "engine/linear/banded_cholesky.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rouleau::linear {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Matrix random_banded(int n, int bandwidth) {
  Matrix a = Matrix::Random(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (std::abs(i - j) > bandwidth) a(i, j) = 0;
    }
  }
  a = (a + a.transpose()).eval();
  a.diagonal().array() += 4 * bandwidth + 2.5;
  return a;
}

void fill(BandedCholesky& banded, const Matrix& a, int bandwidth) {
  const int n = static_cast<int>(a.rows());
  banded.reset(n, bandwidth);
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - bandwidth); j <= i; ++j) banded.at(i, j) = a(i, j);
  }
}

TEST(BandedCholesky, AgreesWithADenseSolve) {
  EXPECT_TRUE(rc::check([] {
    std::srand(*rc::gen::arbitrary<unsigned>());
    BandedCholesky banded;
    for (int again = 0; again < 2; ++again) {
      const int n = *rc::gen::inRange(1, 60), bandwidth = *rc::gen::inRange(0, n);
      const Matrix a = random_banded(n, bandwidth);
      fill(banded, a, bandwidth);
      RC_ASSERT(banded.factor());
      const Vector b = Vector::Random(n);
      Vector x = b;
      banded.solve({x.data(), static_cast<std::size_t>(n)});
      RC_ASSERT((a * x - b).norm() < 1e-10 * (1 + b.norm()));
    }
  }));
}

TEST(BandedCholesky, RefusesWhatIsNotPositiveDefinite) {
  Matrix a = random_banded(9, 2);
  a(4, 4) = -1;
  BandedCholesky banded;
  fill(banded, a, 2);
  EXPECT_FALSE(banded.factor());
  fill(banded, Matrix::Zero(3, 3), 1);
  EXPECT_FALSE(banded.factor());
  a(4, 4) = std::nan("");
  fill(banded, a, 2);
  EXPECT_FALSE(banded.factor());
}

}  // namespace
}  // namespace rouleau::linear
