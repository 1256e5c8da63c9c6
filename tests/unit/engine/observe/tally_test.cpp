#include "engine/observe/tally.h"

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

void set_flow(effects::State& state, double factor) {
  auto& particles = state.particles;
  for (int i = 0; i < particles.active_end(); ++i) {
    particles.u[i] = factor * 6 * particles.y[i] * (1 - particles.y[i]);
  }
}

RunSummary after(const Tally& tally) {
  RunSummary summary;
  tally.report(summary);
  return summary;
}

TEST(Tally, SumsWhatFlowsThrough) {
  effects::State state = effects::prepared_state(coarse_vessel());
  Tally tally(state);
  set_flow(state, 1);
  state.dt = 0.25;
  for (int k = 0; k < 4; ++k) tally.follow(state);
  const RunSummary summary = after(tally);
  EXPECT_NEAR(summary.volume_in, 10e-6 * 10e-6, 1e-9 * 1e-10);
  EXPECT_NEAR(summary.volume_out, 10e-6 * 10e-6, 1e-9 * 1e-10);
  EXPECT_NEAR(summary.volume_mismatch, 0, 1e-9);
}

TEST(Tally, TakesTheMismatchOverWhatPassedEitherWay) {
  Case scene = coarse_vessel();
  scene.vessel.length = 30e-6;
  effects::State forth = effects::prepared_state(scene);
  forth.dt = 1;
  set_flow(forth, 1);
  effects::State back = forth;
  set_flow(back, -1);
  Tally even(forth);
  even.follow(forth);
  even.follow(back);
  EXPECT_NEAR(after(even).volume_in, 0, 1e-9 * 1e-10);
  EXPECT_NEAR(after(even).volume_mismatch, 0, 1e-9);

  // On the way back nothing comes in through the outlet.
  for (int i = 0; i < back.particles.active_end(); ++i) {
    if (back.particles.x[i] > 1.5) back.particles.u[i] = 0;
  }
  Tally uneven(forth);
  uneven.follow(forth);
  uneven.follow(back);
  EXPECT_NEAR(after(uneven).volume_mismatch, 0.5, 1e-9);
}

TEST(Tally, ComparesWithAParabolaOnlyWhereOneIsExpected) {
  const auto deviation_of = [](const Case& scene) {
    effects::State state = effects::prepared_state(scene);
    Tally tally(state);
    set_flow(state, 1);
    state.time = scene.duration / state.scales.time();
    tally.follow(state);
    return after(tally).poiseuille_deviation;
  };
  EXPECT_NEAR(deviation_of(coarse_vessel()), 0, 1e-9);
  Case pulsating = coarse_vessel();
  pulsating.inflow.waveform = {{0, 1}, {1e-3, 2}};
  EXPECT_EQ(deviation_of(pulsating), -1);
  Case driven = coarse_vessel();
  driven.body_acceleration = {1, 0};
  EXPECT_EQ(deviation_of(driven), -1);
  Case periodic = coarse_vessel();
  periodic.vessel.ends = Ends::periodic;
  EXPECT_EQ(deviation_of(periodic), -1);
  EXPECT_EQ(deviation_of(coarse_vessel_with_cells()), -1);
}

TEST(Tally, HasNoVolumesWithoutOpenings) {
  Case scene = coarse_vessel();
  scene.vessel.ends = Ends::periodic;
  effects::State state = effects::prepared_state(scene);
  Tally tally(state);
  set_flow(state, 1);
  tally.follow(state);
  EXPECT_EQ(after(tally).volume_in, 0);
  EXPECT_EQ(after(tally).volume_out, 0);
  EXPECT_EQ(after(tally).volume_mismatch, 0);
}

}  // namespace
}  // namespace rouleau::observe
