#include "engine/observe/wall_shear.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

constexpr double viscosity = 1e-3;  // Pa s, of plasma
constexpr double mean = 5e-3, diameter = 10e-6;

Case with_stress(Case scene) {
  scene.output.fields.push_back(Field::wall_shear_stress);
  return scene;
}

using Field2 = std::function<std::array<double, 2>(double x, double y)>;  // m/s at m

struct Sampled {
  WallNodes nodes;
  std::vector<float> stress;
};

/// The stress of a flow that nobody computed.
Sampled sampled(const Case& scene, const Field2& velocity) {
  effects::State state = effects::prepared_state(scene);
  auto& particles = state.particles;
  for (int i = 0; i < particles.active_end(); ++i) {
    const auto [u, v] = velocity(particles.x[i] * state.scales.length, particles.y[i] * state.scales.length);
    particles.u[i] = u / state.scales.velocity;
    particles.v[i] = v / state.scales.velocity;
  }
  const WallShear shear(state);
  return {shear.nodes(), shear.stress(state)};
}

std::array<double, 2> poiseuille(double, double y) {
  return {6 * mean * (y / diameter) * (1 - y / diameter), 0};
}

TEST(WallShear, OfPoiseuilleFlowIsExactOnBothWalls) {
  const Sampled found = sampled(with_stress(coarse_vessel()), poiseuille);
  ASSERT_EQ(found.stress.size(), 30u);
  for (const float stress : found.stress) EXPECT_NEAR(stress, 6 * viscosity * mean / diameter, 1e-6);
}

TEST(WallShear, IsNegativeWhereTheFlowGoesBack) {
  const Sampled found = sampled(with_stress(coarse_vessel()), [](double x, double y) {
    const auto forth = poiseuille(x, y);
    return std::array<double, 2>{-forth[0], 0};
  });
  for (const float stress : found.stress) EXPECT_NEAR(stress, -6 * viscosity * mean / diameter, 1e-6);
}

TEST(WallShear, IsThatOfTheVelocityBesideTheWalls) {
  Case scene = with_stress(coarse_vessel());
  scene.vessel.ends = Ends::periodic;
  scene.vessel.wall_velocity.upper = mean;
  const Sampled found = sampled(scene, [](double, double y) {
    return std::array<double, 2>{mean * y / diameter, 0};
  });
  ASSERT_EQ(found.stress.size(), 30u);
  for (std::size_t i = 0; i < found.stress.size(); ++i) {
    const bool lower = found.nodes.wall[i] == 0;
    EXPECT_NEAR(found.stress[i], (lower ? 1 : -1) * viscosity * mean / diameter, 1e-6) << "node " << i;
  }
}

TEST(WallShear, HoldsOnAnArc) {
  Case scene = with_stress(coarse_vessel());
  scene.vessel.length = 24e-6;
  scene.numerics.spacing = 0.4e-6;
  const double x0 = 12e-6, radius = 3.2e-6;
  scene.thrombi.push_back({Wall::lower, x0, radius});
  // About the thrombus's centre, clockwise, at rest on it: u = s (r - R^2/r) with slope 2 s.
  constexpr double s = 1e3;
  const Sampled found = sampled(scene, [&](double x, double y) {
    const double dx = x - x0, r = std::hypot(dx, y);
    const double along = s * (r - radius * radius / r);
    return std::array<double, 2>{along * y / r, -along * dx / r};
  });
  int on_arc = 0;
  bool crest = false;
  for (std::size_t i = 0; i < found.stress.size(); ++i) {
    const double dx = found.nodes.x[i] - x0, y = found.nodes.y[i];
    if (y < 0.4 * radius || y > 2 * radius) continue;  // clear of the corners at its feet
    ++on_arc;
    EXPECT_NEAR(std::hypot(dx, y), radius, 1e-9 * radius);
    EXPECT_NEAR(found.nodes.nx[i], dx / radius, 1e-9);
    EXPECT_NEAR(found.nodes.ny[i], y / radius, 1e-9);
    EXPECT_NEAR(found.stress[i], 2 * s * viscosity, 0.02 * 2 * s * viscosity) << "x - x0 = " << dx;
    crest |= std::abs(dx) < 1e-12;
  }
  EXPECT_GT(on_arc, 15);
  EXPECT_TRUE(crest);
}

TEST(WallShear, NodesGoFromTheInletToTheOutletWallByWall) {
  Case scene = with_stress(coarse_vessel());
  scene.vessel.length = 20e-6;
  scene.thrombi.push_back({Wall::upper, 10e-6, 2e-6});
  const Sampled found = sampled(scene, poiseuille);
  const WallNodes& nodes = found.nodes;
  double lower_end = 0, upper_end = 0;
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    EXPECT_EQ(nodes.wall[i], nodes.y[i] < diameter / 2 ? 0 : 1);
    EXPECT_GT(nodes.ny[i] * (nodes.wall[i] == 0 ? 1 : -1), 0);
    if (i > 0 && nodes.wall[i] == nodes.wall[i - 1]) {
      EXPECT_GT(nodes.x[i], nodes.x[i - 1]);
      EXPECT_GT(nodes.arc_length[i], nodes.arc_length[i - 1]);
    }
    (nodes.wall[i] == 0 ? lower_end : upper_end) = nodes.arc_length[i];
  }
  EXPECT_NEAR(lower_end, 20e-6 - 0.5e-6, 1e-12);
  EXPECT_NEAR(upper_end, 20e-6 + (std::numbers::pi - 2) * 2e-6 - 0.5e-6, 1e-12);
}

TEST(WallShear, ComesWithEveryFrame) {
  Case scene = with_stress(coarse_vessel());
  Recorder recorder;
  run_case(scene, recorder);
  ASSERT_EQ(recorder.header.walls.x.size(), 30u);
  ASSERT_EQ(recorder.frames.size(), 5u);
  for (const Frame& frame : recorder.frames) EXPECT_EQ(frame.wall_shear_stress.size(), 30u);
  Recorder without;
  run_case(coarse_vessel(), without);
  EXPECT_TRUE(without.header.walls.x.empty());
  EXPECT_TRUE(without.frames.back().wall_shear_stress.empty());
}

}  // namespace
}  // namespace rouleau::observe
