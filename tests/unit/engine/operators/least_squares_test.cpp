#include "engine/operators/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/engine/operators/disordered_vessel.h"

namespace rouleau::operators {
namespace {

using particles::Group;
using particles::NeighbourList;
using particles::ParticleSet;

constexpr double spacing = 0.05, radius = 3.1 * spacing;

NeighbourList neighbours_of(const ParticleSet& set) {
  NeighbourList list({-1, -1, 3, 2}, radius, 2.1 * spacing);
  list.build(set);
  return list;
}

struct Quadratic {
  std::array<double, 6> c;

  explicit Quadratic(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coefficient(-1, 1);
    for (double& value : c) value = coefficient(random);
  }
  double operator()(double x, double y) const {
    return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
  }
  Gradient gradient(double x, double y) const {
    return {c[1] + 2 * c[3] * x + c[4] * y, c[2] + c[4] * x + 2 * c[5] * y};
  }
  double laplacian() const { return 2 * (c[3] + c[5]); }
};

template <class Field>
std::vector<double> sample(const ParticleSet& set, const Field& field) {
  std::vector<double> values;
  for (int i = 0; i < set.size(); ++i) values.push_back(field(set.x[i], set.y[i]));
  return values;
}

double laplacian_of(const LeastSquares& fit, const NeighbourList& list, int i,
                    const std::vector<double>& field) {
  double sum = 0;
  for (int k = list.begin(i); k < list.end(i); ++k)
    sum += fit.laplacian(i)[k - list.begin(i)] * (field[list.j[k]] - field[i]);
  return sum;
}

/// A seed a cloud.
class DisorderedCloud : public testing::TestWithParam<unsigned> {
 protected:
  DisorderedCloud() { fit_.build(set_, list_); }

  const ParticleSet set_ = disordered_vessel(1, spacing, 0.3, GetParam());
  const NeighbourList list_ = neighbours_of(set_);
  LeastSquares fit_;
};

TEST_P(DisorderedCloud, VelocityDerivativesOfQuadraticsAreExact) {
  ASSERT_EQ(fit_.poor_rows(), 0);
  ASSERT_GT(list_.rows(), 300);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Quadratic field(100 * GetParam() + seed);
    const auto values = sample(set_, field);
    for (int i = 0; i < list_.rows(); ++i) {
      const Gradient exact = field.gradient(set_.x[i], set_.y[i]);
      const Gradient found = fit_.velocity_gradient(i, values.data());
      ASSERT_NEAR(found.x, exact.x, 1e-4);
      ASSERT_NEAR(found.y, exact.y, 1e-4);
      // Weights of the second derivatives are larger by 1 / radius: so is what rounds off of them.
      ASSERT_NEAR(laplacian_of(fit_, list_, i, values), field.laplacian(), 1e-4 / radius);
    }
  }
}

TEST_P(DisorderedCloud, AwayFromWallsTheLaplacianHoldsTheFourthPowerOfTheDistance) {
  int away = 0;
  for (int i = 0; i < list_.rows(); ++i) {
    if (list_.last_neighbour(i) >= set_.pressure_end()) continue;
    const auto values = sample(set_, [&](double x, double y) {
      const double r2 = (x - set_.x[i]) * (x - set_.x[i]) + (y - set_.y[i]) * (y - set_.y[i]);
      return r2 * r2;
    });
    // A quadratic fit finds 4 <r^6>/<r^4>, about 1.9 radius^2.
    ASSERT_NEAR(laplacian_of(fit_, list_, i, values), 0, 1e-4 * radius * radius);
    ++away;
  }
  EXPECT_GT(away, 100);
}

TEST_P(DisorderedCloud, PressureGradientsOfQuadraticsAreExactWithoutTheWalls) {
  ASSERT_EQ(fit_.poor_rows(), 0);
  const Quadratic field(GetParam());
  auto values = sample(set_, field);
  std::fill(values.begin() + set_.pressure_end(), values.end(), 1e6);
  int beside_walls = 0;
  for (int i = 0; i < list_.rows(); ++i) {
    const Gradient exact = field.gradient(set_.x[i], set_.y[i]);
    const Gradient found = fit_.pressure_gradient(i, values.data());
    ASSERT_NEAR(found.x, exact.x, 1e-4);
    ASSERT_NEAR(found.y, exact.y, 1e-4);
    beside_walls += set_.y[i] < radius;
  }
  EXPECT_GT(beside_walls, 20);
}

TEST_P(DisorderedCloud, WallsAreDataForVelocities) {
  auto values = sample(set_, [](double, double) { return 0.0; });
  std::fill(values.begin() + set_.inlet_end(), values.begin() + set_.velocity_end(), 1.0);
  int felt = 0;
  for (int i = 0; i < list_.rows(); ++i) {
    if (set_.y[i] < spacing) felt += fit_.velocity_gradient(i, values.data()).y < -0.1 / spacing;
    if (set_.y[i] > radius && set_.y[i] < 1 - radius) {
      ASSERT_EQ(fit_.velocity_gradient(i, values.data()).y, 0);
    }
  }
  EXPECT_GT(felt, 5);
}

TEST_P(DisorderedCloud, ConstantsMapToZero) {
  const std::vector<double> values(set_.x.size(), 3.7);
  for (int i = 0; i < list_.rows(); ++i) {
    const Gradient u = fit_.velocity_gradient(i, values.data()), p = fit_.pressure_gradient(i, values.data());
    ASSERT_EQ(u.x, 0);
    ASSERT_EQ(u.y, 0);
    ASSERT_EQ(p.x, 0);
    ASSERT_EQ(p.y, 0);
    ASSERT_EQ(laplacian_of(fit_, list_, i, values), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DisorderedCloud, testing::Range(1u, 6u));

TEST_P(DisorderedCloud, AllAtOnceIsWhatOneByOneIs) {
  const Quadratic of_u(7), of_v(8);
  const auto u = sample(set_, of_u), v = sample(set_, of_v);
  std::vector<double> uv, fields, divergences, gradients, slopes, laplacians, weights;
  interleave(u, v, uv);
  // The pressure is the u of before, for which walls count only as velocity.
  for (std::size_t i = 0; i < u.size(); ++i) fields.insert(fields.end(), {u[i], v[i], u[i], 0});
  LeastSquares fit = fit_;
  fit.field_gradients(fields.data(), u.data(), gradients);
  fit_.divergences(uv.data(), divergences);
  fit_.pressure_gradients(u.data(), slopes);
  fit_.velocity_laplacians(uv.data(), laplacians, weights);
  std::vector<float> products(laplacians.size()), uv_in_float(uv.begin(), uv.end());
  fit_.laplacian_products(uv_in_float.data(), products.data());
  for (int i = 0; i < list_.rows(); ++i) {
    const Gradient gu = fit_.velocity_gradient(i, u.data()), gv = fit_.velocity_gradient(i, v.data());
    const Gradient gp = fit_.pressure_gradient(i, u.data());
    ASSERT_NEAR(gradients[8 * i], gu.x, 1e-12);
    ASSERT_NEAR(gradients[8 * i + 1], gv.x, 1e-12);
    ASSERT_NEAR(gradients[8 * i + 2], gp.x, 1e-12);
    ASSERT_NEAR(gradients[8 * i + 4], gu.y, 1e-12);
    ASSERT_NEAR(gradients[8 * i + 5], gv.y, 1e-12);
    ASSERT_NEAR(gradients[8 * i + 6], gp.y, 1e-12);
    ASSERT_NEAR(divergences[i], gu.x + gv.y, 1e-12);
    ASSERT_NEAR(slopes[2 * i], gp.x, 1e-12);
    ASSERT_NEAR(slopes[2 * i + 1], gp.y, 1e-12);
    ASSERT_NEAR(laplacians[2 * i], laplacian_of(fit_, list_, i, u), 1e-10);
    ASSERT_NEAR(laplacians[2 * i + 1], laplacian_of(fit_, list_, i, v), 1e-10);
    ASSERT_NEAR(products[2 * i] - weights[i] * u[i], laplacians[2 * i], 1e-5 * weights[i]);
    ASSERT_NEAR(products[2 * i + 1] - weights[i] * v[i], laplacians[2 * i + 1], 1e-5 * weights[i]);
  }
}

TEST(LeastSquares, SecondOrderInTheSpacing) {
  // Of a field that is no quadratic, the gradient's error falls with the square of the spacing.
  const auto worst = [](double d0) {
    const ParticleSet set = disordered_vessel(0.5, d0, 0.2, 8);
    NeighbourList list({-1, -1, 3, 2}, 3.1 * d0, 2.1 * d0);
    list.build(set);
    LeastSquares fit;
    fit.build(set, list);
    const auto values = sample(set, [](double x, double y) { return std::sin(3 * x) * std::cos(2 * y); });
    double sum = 0;
    for (int i = 0; i < list.rows(); ++i) {
      const double exact = 3 * std::cos(3 * set.x[i]) * std::cos(2 * set.y[i]);
      sum += std::abs(fit.velocity_gradient(i, values.data()).x - exact);
    }
    return sum / list.rows();
  };
  EXPECT_GT(worst(0.1) / worst(0.05), 3);
}

void expect_finite(const LeastSquares& fit, const NeighbourList& list) {
  for (int i = 0; i < list.rows(); ++i) {
    const int n = list.padded_end(i) - list.begin(i);
    for (const float* weights :
         {fit.dx(i), fit.dy(i), fit.laplacian(i), fit.pressure_dx(i), fit.pressure_dy(i)}) {
      EXPECT_TRUE(std::all_of(weights, weights + n, [](float w) { return std::isfinite(w); }));
    }
  }
}

struct PoorCase {
  const char* name;
  std::function<void(ParticleSet&)> place;
};

class PoorNeighbourhood : public testing::TestWithParam<PoorCase> {};

TEST_P(PoorNeighbourhood, HasFiniteWeightsAndIsCounted) {
  ParticleSet set;
  GetParam().place(set);
  sort_particles(set, spacing);
  const NeighbourList list = neighbours_of(set);
  LeastSquares fit;
  fit.build(set, list);
  expect_finite(fit, list);
  EXPECT_GT(fit.poor_rows(), 0);
  const auto values = sample(set, Quadratic(1));
  for (int i = 0; i < list.rows(); ++i) {
    EXPECT_LT(std::abs(fit.velocity_gradient(i, values.data()).x), 100);
    EXPECT_LT(std::abs(fit.pressure_gradient(i, values.data()).x), 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Places, PoorNeighbourhood,
                         testing::Values(PoorCase{"alone",
                                                  [](ParticleSet& s) { s.add(Group::fluid, 0.5, 0.5); }},
                                         PoorCase{"pair",
                                                  [](ParticleSet& s) {
                                                    s.add(Group::fluid, 0.5, 0.5);
                                                    s.add(Group::fluid, 0.55, 0.5);
                                                  }},
                                         PoorCase{"nearly_one_place",
                                                  [](ParticleSet& s) {
                                                    s.add(Group::fluid, 0.5, 0.5);
                                                    s.add(Group::fluid, 0.5 + 1e-12, 0.5);
                                                    s.add(Group::fluid, 0.5, 0.5);
                                                  }},
                                         PoorCase{"collinear",
                                                  [](ParticleSet& s) {
                                                    for (int k = 0; k < 9; ++k)
                                                      s.add(Group::fluid, 0.3 + 0.04 * k, 0.5);
                                                  }},
                                         PoorCase{"collinear_aslant",
                                                  [](ParticleSet& s) {
                                                    for (int k = 0; k < 9; ++k)
                                                      s.add(Group::fluid, 0.3 + 0.03 * k, 0.2 + 0.02 * k);
                                                  }},
                                         PoorCase{"walls_alone",
                                                  [](ParticleSet& s) {
                                                    s.add(Group::fluid, 0.5, 0.03);
                                                    for (int k = -4; k <= 4; ++k)
                                                      s.add(Group::wall, 0.5 + spacing * k, 0);
                                                  }}),
                         [](const auto& poor) { return std::string(poor.param.name); });

TEST(LeastSquares, FewNeighboursStillCarryALinearPressure) {
  ParticleSet set;
  set.add(Group::membrane, 0.5, 0.5);
  for (const auto& [x, y] : {std::pair{0.45, 0.51}, {0.55, 0.48}, {0.51, 0.56}}) set.add(Group::wall, x, y);
  for (const auto& [x, y] : {std::pair{0.44, 0.50}, {0.53, 0.47}, {0.5, 0.57}}) set.add(Group::outlet, x, y);
  sort_particles(set, spacing);
  const NeighbourList list = neighbours_of(set);
  LeastSquares fit;
  fit.build(set, list);
  ASSERT_GT(fit.poor_rows(), 0);
  const auto values = sample(set, [](double x, double y) { return 2 * x - 3 * y; });
  const Gradient found = fit.pressure_gradient(0, values.data());
  EXPECT_NEAR(found.x, 2, 1e-4);
  EXPECT_NEAR(found.y, -3, 1e-4);
}

}  // namespace
}  // namespace rouleau::operators
