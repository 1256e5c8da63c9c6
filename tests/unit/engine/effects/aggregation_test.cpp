#include "engine/effects/aggregation.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numeric>

#include <gtest/gtest.h>

#include "engine/case/presets.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// At 1 um a node, so that the potential must reach as far.
EffectWish coarse_potential() {
  return {Switch::on, {{"well_depth", 1e-7}, {"zero_force_distance", 1e-6}, {"scaling_factor", 2e6}}};
}

Case attracted(Case scene) {
  scene.effects["aggregation"] = coarse_potential();
  return scene;
}

void move(State& state, const CellState& cell, double dx) {
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) state.particles.x[i] += dx;
}

double least(const State& state, const CellState& cell) {
  const auto first = state.particles.x.begin() + cell.first_node;
  return *std::min_element(first, first + cell.nodes);
}

double most(const State& state, const CellState& cell) {
  const auto first = state.particles.x.begin() + cell.first_node;
  return *std::max_element(first, first + cell.nodes);
}

/// Two cells, this far apart (m).
State pair(double gap) {
  State state = prepared_state(attracted(coarse_vessel_with_cells(2)));
  move(state, state.cells[1],
       most(state, state.cells[0]) + gap / state.scales.length - least(state, state.cells[1]));
  return state;
}

TEST(Aggregation, IsOffUnlessAskedFor) {
  const Need need = aggregation.need(coarse_vessel_with_cells(2));
  // A zero-force distance of 0.49 um is not resolved by 1 um.
  EXPECT_FALSE(need.called_for || need.on_request);
  Case fine = coarse_vessel_with_cells(2);
  fine.numerics.spacing = 0.4e-6;
  EXPECT_FALSE(aggregation.need(fine).called_for);
  EXPECT_TRUE(aggregation.need(fine).on_request);
}

TEST(Aggregation, IsRefusedWhereThereIsNothingToAttract) {
  Case published = attracted(coarse_vessel_with_cells(2));
  published.numerics = preset_numerics(Preset::paper);
  for (const Case& scene : {attracted(coarse_vessel()), attracted(coarse_vessel_with_cells(1)), published}) {
    const Need need = aggregation.need(scene);
    EXPECT_FALSE(need.called_for || need.on_request);
    EXPECT_FALSE(need.reason.empty());
  }
  EXPECT_TRUE(aggregation.need(attracted(coarse_vessel_with_cells(2))).on_request);
  Case periodic = attracted(coarse_vessel_with_cells(1));
  periodic.vessel.ends = Ends::periodic;
  EXPECT_TRUE(aggregation.need(periodic).on_request);
}

TEST(Aggregation, SaysWhatSpacingWouldResolveItsDistance) {
  Case scene = attracted(coarse_vessel_with_cells(2));
  scene.effects["aggregation"].parameters["zero_force_distance"] = 0.3e-6;
  const Need need = aggregation.need(scene);
  EXPECT_FALSE(need.on_request);
  EXPECT_THAT(need.reason, testing::HasSubstr("at most 0.4 um"));
  EXPECT_EQ(need.pointer, "/effects/aggregation/zero_force_distance");
}

TEST(Aggregation, SleepsUntilCellsAreWithinItsReach) {
  const double reach = 1e-6 + 5 / 2e6;
  State far = pair(1.01 * reach), near = pair(0.99 * reach);
  EXPECT_FALSE(aggregation.make(far)->awake(far));
  EXPECT_TRUE(aggregation.make(near)->awake(near));
}

TEST(Aggregation, PullsCellsTogetherAndPushesThemOffWithinItsDistance) {
  for (const double gap : {0.5e-6, 1.3e-6}) {
    State state = pair(gap);
    const auto effect = aggregation.make(state);
    ASSERT_TRUE(effect->awake(state));
    effect->apply(state);
    const auto split = state.load.fx.begin() + state.cells[1].first_node;
    const double left = std::accumulate(state.load.fx.begin(), split, 0.0);
    const double right = std::accumulate(split, state.load.fx.end(), 0.0);
    EXPECT_EQ(left > 0, gap > 1e-6) << gap;
    EXPECT_NEAR(left, -right, 1e-12 * std::abs(left));
    double torque = 0;
    for (int i = 0; i < state.particles.membrane_end(); ++i) {
      torque += state.particles.x[i] * state.load.fy[i] - state.particles.y[i] * state.load.fx[i];
    }
    EXPECT_NEAR(torque, 0, 1e-11 * std::abs(left));
    EXPECT_FALSE(state.load.stiffness.empty());
    for (const cells::Stiffness& term : state.load.stiffness) EXPECT_GT(term.k, 0);
  }
}

TEST(Aggregation, ActsAcrossASeamAsInTheMiddle) {
  State middle = prepared_state(attracted(pair_around(10e-6, 4e-6)));
  State across = prepared_state(attracted(pair_around(0, 4e-6)));
  for (State* state : {&middle, &across}) {
    const auto effect = aggregation.make(*state);
    ASSERT_TRUE(effect->awake(*state));
    effect->apply(*state);
  }
  const double strongest = *std::max_element(middle.load.fx.begin(), middle.load.fx.end());
  ASSERT_GT(strongest, 0);
  for (std::size_t q = 0; q < middle.load.fx.size(); ++q) {
    EXPECT_NEAR(across.load.fx[q], middle.load.fx[q], 1e-9 * strongest);
    EXPECT_NEAR(across.load.fy[q], middle.load.fy[q], 1e-9 * strongest);
  }
}

/// A cell that all but fills its period is attracted by its own images, alike on both sides.
TEST(Aggregation, AnImageOfACellIsAnother) {
  Case scene = attracted(coarse_vessel_with_cells(1));
  scene.vessel.ends = Ends::periodic;
  scene.vessel.length = 10e-6;
  scene.cells[0].x = 5e-6;
  scene.cells[0].angle = 0;
  State state = prepared_state(scene);
  const auto effect = aggregation.make(state);
  ASSERT_TRUE(effect->awake(state));
  effect->apply(state);
  const auto rightmost =
      std::max_element(state.particles.x.begin(), state.particles.x.begin() + state.cells[0].nodes) -
      state.particles.x.begin();
  EXPECT_GT(state.load.fx[static_cast<std::size_t>(rightmost)], 0);
  EXPECT_NEAR(std::accumulate(state.load.fx.begin(), state.load.fx.end(), 0.0), 0,
              1e-12 * state.load.fx[static_cast<std::size_t>(rightmost)]);
}

TEST(Aggregation, BringsTwoCellsTogether) {
  Case scene = pair_around(10e-6, 5e-6);
  scene.effects["aggregation"] = {
      Switch::on, {{"well_depth", 1e-5}, {"zero_force_distance", 1e-6}, {"scaling_factor", 2e6}}};
  scene.numerics.time_step = 2e-6;
  Simulation simulation(scene);
  const auto apart = [&] {
    const State& state = simulation.state();
    return least(state, state.cells[1]) - most(state, state.cells[0]);
  };
  const double before = apart();
  for (int k = 0; k < 60; ++k) simulation.step();
  EXPECT_LT(apart(), before - 0.05 * (before - 0.1));
}

}  // namespace
}  // namespace rouleau::effects
