#include "engine/cells/tank_treading.h"

#include <gtest/gtest.h>

#include "tests/unit/engine/cells/analytic_rings.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

/// An ellipse whose membrane is at the phase psi, inclined by theta, with the velocities of both turning.
struct Motion {
  Nodes at, velocity;
};

Motion ellipse(double a, double b, double theta, double psi, double theta_rate, double psi_rate, int n = 40) {
  const auto place = [&](double t) {
    return turned(ring_of(n,
                          [&](double s) {
                            const double phase = s + (psi + t * psi_rate) * pi / 180;
                            return std::array{a * std::cos(phase), b * std::sin(phase)};
                          }),
                  theta + t * theta_rate, 8, -2);
  };
  const double step = 1e-6;
  const Nodes before = place(-step), after = place(step);
  Motion motion{place(0), {}};
  for (int i = 0; i < n; ++i) {
    motion.velocity.x.push_back((after.x[i] - before.x[i]) / (2 * step));
    motion.velocity.y.push_back((after.y[i] - before.y[i]) / (2 * step));
  }
  return motion;
}

TankTreading of(const Motion& motion) {
  return tank_treading(motion.at.ring(), motion.velocity.x, motion.velocity.y);
}

TEST(TankTreading, PhaseIsThatOfTheMembraneAroundTheShape) {
  for (const double theta : {0.0, 25.0, 90.0, -70.0}) {
    for (const double psi : {-80.0, -10.0, 0.0, 45.0, 90.0}) {
      EXPECT_NEAR(of(ellipse(3, 1, theta, psi, 0, 0)).phase, psi, 1e-9) << theta;
    }
  }
}

TEST(TankTreading, FrequencyLeavesTumblingOut) {
  EXPECT_NEAR(of(ellipse(3, 1, 20, 30, 0, 720)).frequency, 2, 1e-7);
  EXPECT_NEAR(of(ellipse(3, 1, 20, 30, 0, -90)).frequency, -0.25, 1e-7);
  EXPECT_NEAR(of(ellipse(3, 1, 20, 30, 500, 0)).frequency, 0, 1e-7);
  EXPECT_NEAR(of(ellipse(3, 1, 20, 30, -500, 360)).frequency, 1, 1e-7);
}

TEST(TankTreading, OfACircleIsItsRotation) {
  const TankTreading circle = of(ellipse(2, 2, 0, 35, 0, 180));
  EXPECT_NEAR(circle.phase, 35, 1e-9);
  EXPECT_NEAR(circle.frequency, 0.5, 1e-7);
  EXPECT_NEAR(of(ellipse(2, 2, 35, 0, 180, 0)).frequency, 0.5, 1e-7);
}

TEST(TankTreading, NeitherTranslationNorSwellingIsTreading) {
  Motion motion = ellipse(3, 1, 20, 30, 0, 0);
  for (std::size_t i = 0; i < motion.at.x.size(); ++i) {
    motion.velocity.x[i] = 5 + 0.3 * (motion.at.x[i] - 8);
    motion.velocity.y[i] = -7 + 0.3 * (motion.at.y[i] + 2);
  }
  EXPECT_NEAR(of(motion).frequency, 0, 1e-12);
}

TEST(TankTreading, AxesHaveNoDirection) {
  EXPECT_EQ(axis_angle(90), 90);
  EXPECT_EQ(axis_angle(-90), 90);
  EXPECT_EQ(axis_angle(270), 90);
  EXPECT_EQ(axis_angle(190), 10);
  EXPECT_EQ(axis_angle(-100), 80);
}

}  // namespace
}  // namespace rouleau::cells
