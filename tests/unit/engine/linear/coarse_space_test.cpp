#include "engine/linear/coarse_space.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace rouleau::linear {
namespace {

/// Six rows in three aggregates, coupled in a chain.
class ChainOfAggregates : public testing::Test {
 protected:
  const Aggregates aggregates_{{0, 0, 1, 1, 2, 2}, 3, 1};
  CoarseSpace coarse_;
};

TEST_F(ChainOfAggregates, SolvesTheSymmetricPartOfTheSummedMatrix) {
  coarse_.reset(aggregates_);
  Eigen::Matrix3d matrix;
  matrix << 4, -1, 0, -2, 5, -1, 0, -3, 6;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      if (std::abs(a - b) > 1) continue;
      coarse_.add(a, b, 0.25 * matrix(a, b));
      coarse_.add(a, b, 0.75 * matrix(a, b));
    }
  }
  coarse_.factor();
  // Two components, interleaved.
  const std::vector<float> residual{1, 10, 2, 20, 3, 30, 4, 40, 5, 50, 6, 60};
  const Eigen::Vector3d sums(3, 7, 11);
  const Eigen::Vector3d exact = (0.5 * (matrix + matrix.transpose())).llt().solve(sums);
  const auto first = coarse_.correct(std::span<const float>(residual), 2, 0);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(first[a], exact[a], 1e-12);
  const auto second = coarse_.correct(std::span<const float>(residual), 2, 1);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(second[a], 10 * exact[a], 1e-11);
}

TEST_F(ChainOfAggregates, CorrectsNothingWhereTheMatrixIsNotDefinite) {
  coarse_.reset(aggregates_);
  for (int a = 0; a < 3; ++a) coarse_.add(a, a, 1);
  coarse_.add(0, 1, 9);
  coarse_.factor();
  const std::vector<double> residual(6, 1);
  for (const double z : coarse_.correct(std::span<const double>(residual))) EXPECT_EQ(z, 0);
}

TEST_F(ChainOfAggregates, StandsAMatrixThatIgnoresConstants) {
  coarse_.reset(aggregates_);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2)}) {
    coarse_.add(a, a, 1);
    coarse_.add(b, b, 1);
    coarse_.add(a, b, -1);
    coarse_.add(b, a, -1);
  }
  coarse_.factor(true);
  const std::vector<double> residual{1, 0, 0, 0, 0, -1};
  const auto z = coarse_.correct(std::span<const double>(residual));
  EXPECT_NEAR(z[0] - z[1], 1, 1e-6);
  EXPECT_NEAR(z[1] - z[2], 1, 1e-6);
}

}  // namespace
}  // namespace rouleau::linear
