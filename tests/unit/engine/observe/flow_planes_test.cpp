#include "engine/observe/flow_planes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/observe/fluid_segments.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

constexpr double spacing = 0.1;

/// A vessel full of particles on a lattice, which all move as one.
effects::State moving_as_one(const Case& scene, double u, double v) {
  effects::State state(scene, scales_of(scene), spacing);
  const geometry::Bounds box = state.outline.bounds();
  for (double x = box.x0 - spacing; x < box.x1 + spacing; x += spacing) {
    for (double y = box.y0 - spacing; y < box.y1 + spacing; y += spacing) {
      const int i = state.particles.add(particles::Group::fluid, x, y);
      state.particles.u[i] = u;
      state.particles.v[i] = v;
    }
  }
  sort_particles(state.particles, spacing);
  return state;
}

Case bifurcation() {
  Case scene = coarse_vessel();
  scene.vessel.shape = Shape::bifurcation;
  scene.vessel.branches = {Branch{30e-6, 8e-6}, Branch{35e-6, 6e-6}};
  return scene;
}

TEST(FlowPlanes, StandSixSpacingsInsideAnOpenVessel) {
  const effects::State state = moving_as_one(coarse_vessel(), 1, 0);
  const FlowPlanes planes = flow_planes(state);
  ASSERT_EQ(planes.inlet.size(), 1u);
  ASSERT_EQ(planes.outlets.size(), 1u);
  ASSERT_EQ(planes.outlets[0].size(), 1u);
  EXPECT_NEAR(planes.inlet[0].from[0], 0.6, 1e-12);
  EXPECT_NEAR(planes.outlets[0][0].to[0], 1.5 - 0.6, 1e-12);
  EXPECT_NEAR(total_flux(state.particles, planes.inlet), 1, 1e-9);
  EXPECT_NEAR(total_flux(state.particles, planes.outlets[0]), 1, 1e-9);
}

TEST(FlowPlanes, StayWhereTheyAreWhenTheSpacingBecomesFiner) {
  const Case scene = coarse_vessel();
  const effects::State start(scene, scales_of(scene), spacing),
      finer(scene, scales_of(scene), spacing / 2, spacing);
  EXPECT_EQ(flow_planes(finer).inlet[0].from[0], flow_planes(start).inlet[0].from[0]);
  EXPECT_EQ(pressure_drop(finer, {1, 0.7}), pressure_drop(start, {1, 0.7}));
}

TEST(FlowPlanes, LeaveOutAThrombus) {
  Case scene = coarse_vessel();
  scene.vessel.length = 30e-6;
  scene.thrombi.push_back({Wall::upper, 6e-6, 2e-6});
  const effects::State state = moving_as_one(scene, 1, 0);
  EXPECT_NEAR(total_flux(state.particles, flow_planes(state).inlet), 0.8, 1e-6);
}

TEST(FlowPlanes, OfABifurcationFaceItsBranches) {
  const Case scene = bifurcation();
  const effects::State state = moving_as_one(scene, 1, 0.25);
  const FlowPlanes planes = flow_planes(state);
  ASSERT_EQ(planes.outlets.size(), 2u);
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  EXPECT_NEAR(total_flux(state.particles, planes.inlet), 1, 1e-6);
  EXPECT_NEAR(total_flux(state.particles, planes.outlets[0]), 0.8 * (c - 0.25 * s), 1e-6);
  EXPECT_NEAR(total_flux(state.particles, planes.outlets[1]), 0.6 * (c + 0.25 * s), 1e-6);
  EXPECT_EQ(outlet_count(scene.vessel), 2);
}

TEST(FlowPlanes, OfAPeriodicVesselAreOne) {
  Case scene = coarse_vessel();
  scene.vessel.ends = Ends::periodic;
  const effects::State state = moving_as_one(scene, -0.5, 0);
  const FlowPlanes planes = flow_planes(state);
  ASSERT_EQ(planes.outlets.size(), 1u);
  EXPECT_NEAR(total_flux(state.particles, planes.inlet), -0.5, 1e-9);
  EXPECT_EQ(total_flux(state.particles, planes.outlets[0]), total_flux(state.particles, planes.inlet));
  EXPECT_EQ(pressure_drop(state, {1, 1}), 0);
}

TEST(FlowPlanes, OfABoxLetNothingThrough) {
  Case scene = coarse_vessel();
  scene.vessel.shape = Shape::box;
  scene.vessel.ends = Ends::closed;
  const effects::State state = moving_as_one(scene, 1, 1);
  const FlowPlanes planes = flow_planes(state);
  ASSERT_EQ(planes.outlets.size(), 1u);
  EXPECT_EQ(total_flux(state.particles, planes.inlet), 0);
  EXPECT_EQ(total_flux(state.particles, planes.outlets[0]), 0);
}

TEST(PressureDrop, IsCountedFromTheInletToTheMeanOfTheOutlets) {
  Case scene = bifurcation();
  scene.outflow.pressure = {1, 3};
  const effects::State state = moving_as_one(scene, 1, 0);
  const double unit = state.scales.pressure();
  // What developed flow loses over six spacings of the trunk, as flow along +x and back.
  const double lost = 12 * 1e-3 * 5e-3 / (10e-6 * 10e-6) * 6e-6;
  EXPECT_NEAR(pressure_drop(state, {1, 7 / unit}) * unit, 7 + lost - 2, 1e-9);
  EXPECT_NEAR(pressure_drop(state, {-1, 7 / unit}) * unit, 7 - lost - 2, 1e-9);
}

}  // namespace
}  // namespace rouleau::observe
