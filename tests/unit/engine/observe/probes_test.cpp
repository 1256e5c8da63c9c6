#include "engine/observe/probes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

constexpr double mean = 5e-3, diameter = 10e-6;

double axial(double y) {
  return 6 * mean * (y / diameter) * (1 - y / diameter);
}

/// Pressure of Poiseuille flow of plasma, 0 at the outlet of the coarse vessel.
double pressure(double x) {
  return 12 * 1e-3 * mean / (diameter * diameter) * (15e-6 - x);
}

Case vessel_with(std::vector<Probe> probes) {
  Case scene = coarse_vessel();
  scene.probes = std::move(probes);
  return scene;
}

/// What the probes see of Poiseuille flow that nobody computed.
std::vector<ProbeValues> in_poiseuille_flow(const Case& scene) {
  effects::State state = effects::prepared_state(scene);
  auto& particles = state.particles;
  for (int i = 0; i < particles.size(); ++i) {
    const double x = particles.x[i] * state.scales.length, y = particles.y[i] * state.scales.length;
    const bool in_fluid = i < particles.active_end();
    particles.u[i] = in_fluid ? axial(y) / state.scales.velocity : 0;
    particles.p[i] = in_fluid ? pressure(x) / state.scales.pressure() : 1e6;
  }
  return Probes(state).values(state);
}

TEST(Probes, SeeVelocityAndPressureAlongALine) {
  const Case scene = vessel_with({{"across", {7e-6, 0}, {9e-6, 10e-6}, 21}});
  const auto lines = Probes(effects::prepared_state(scene)).lines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].name, "across");
  ASSERT_EQ(lines[0].x.size(), 21u);
  const ProbeValues seen = in_poiseuille_flow(scene)[0];
  for (std::size_t k = 0; k < 21; ++k) {
    const double s = static_cast<double>(k) / 20;
    EXPECT_NEAR(lines[0].x[k], 7e-6 + 2e-6 * s, 1e-18);
    EXPECT_NEAR(lines[0].y[k], 10e-6 * s, 1e-18);
    EXPECT_NEAR(seen.u[k], axial(lines[0].y[k]), 1e-9 * mean);
    EXPECT_NEAR(seen.v[k], 0, 1e-9 * mean);
    EXPECT_NEAR(seen.p[k], pressure(lines[0].x[k]), 1e-9);
  }
}

TEST(Probes, TheFluxThroughAnyLineAcrossIsThatOfTheVessel) {
  const auto seen = in_poiseuille_flow(vessel_with({{"upright", {7e-6, 0}, {7e-6, 10e-6}, 3},
                                                    {"oblique", {2e-6, 0}, {14e-6, 10e-6}, 3},
                                                    {"downwards", {10e-6, 10e-6}, {5e-6, 0}, 3},
                                                    {"too long", {8e-6, -7e-6}, {8e-6, 30e-6}, 3},
                                                    {"along", {4e-6, 5e-6}, {11e-6, 5e-6}, 3}}));
  const double through = mean * diameter;
  EXPECT_NEAR(seen[0].flux, through, 1e-3 * through);
  EXPECT_NEAR(seen[1].flux, through, 1e-3 * through);
  EXPECT_NEAR(seen[2].flux, -through, 1e-3 * through);
  EXPECT_NEAR(seen[3].flux, through, 1e-3 * through);
  EXPECT_NEAR(seen[4].flux, 0, 1e-3 * through);
}

TEST(Probes, APointHasNoFlux) {
  const Case scene =
      vessel_with({{"point", {7e-6, 5e-6}, {7e-6, 5e-6}, 1}, {"line", {7e-6, 5e-6}, {7e-6, 6e-6}, 1}});
  const auto lines = Probes(effects::prepared_state(scene)).lines();
  EXPECT_FALSE(lines[0].has_flux);
  EXPECT_TRUE(lines[1].has_flux);
  const auto seen = in_poiseuille_flow(scene);
  EXPECT_EQ(seen[0].flux, 0);
  EXPECT_NEAR(seen[0].u[0], 1.5 * mean, 1e-9 * mean);
}

TEST(Probes, OutsideTheFluidThereIsNothing) {
  Case scene = vessel_with(
      {{"through", {10e-6, -2e-6}, {10e-6, 10e-6}, 13}, {"along", {-1e-6, 5e-6}, {21e-6, 5e-6}, 23}});
  scene.vessel.length = 20e-6;
  scene.thrombi.push_back({Wall::lower, 10e-6, 3e-6});
  const effects::State state = effects::prepared_state(scene);
  const auto seen = Probes(state).values(state);
  for (std::size_t k = 0; k < 13; ++k) {
    for (const auto* field : {&seen[0].u, &seen[0].v, &seen[0].p}) {
      EXPECT_EQ(std::isfinite((*field)[k]), k >= 5) << "point " << k << ", the crest is the fifth";
    }
  }
  for (std::size_t k = 0; k < 23; ++k) {
    EXPECT_EQ(std::isfinite(seen[1].u[k]), k >= 1 && k <= 21) << "point " << k;
  }
}

TEST(Probes, TheFluxLeavesOutWhatIsOutsideTheFluid) {
  Case scene = vessel_with({{"across", {10e-6, 0}, {10e-6, 10e-6}, 2}});
  scene.vessel.length = 20e-6;
  scene.thrombi.push_back({Wall::lower, 10e-6, 3e-6});
  effects::State state = effects::prepared_state(scene);
  for (double& u : state.particles.u) u = 1;
  EXPECT_NEAR(Probes(state).values(state)[0].flux, mean * 7e-6, 1e-6 * mean * diameter);
}

TEST(Probes, AreSampledWithEachRowOfTheSeries) {
  const std::vector<Probe> probes{{"point", {7e-6, 5e-6}, {7e-6, 5e-6}, 1}};
  Case scene = vessel_with(probes);
  scene.inflow.profile = Profile::parabolic;
  Recorder recorder;
  run_case(scene, recorder);
  ASSERT_EQ(recorder.header.probes.size(), 1u);
  ASSERT_EQ(recorder.probe_times.size(), recorder.rows.size());
  for (std::size_t r = 0; r < recorder.rows.size(); ++r) {
    EXPECT_EQ(recorder.probe_times[r], recorder.rows[r][0]);
  }
  EXPECT_NEAR(recorder.probe_rows.back()[0].u[0], 1.5 * mean, 0.02 * 1.5 * mean);
  Recorder without;
  run_case(vessel_with({}), without);
  EXPECT_TRUE(without.probe_rows.empty());
}

}  // namespace
}  // namespace rouleau::observe
