#include "engine/effects/contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void move(State& state, const CellState& cell, double dx, double dy) {
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) {
    state.particles.x[i] += dx;
    state.particles.y[i] += dy;
  }
}

double least(const std::vector<double>& values, const CellState& cell) {
  return *std::min_element(values.begin() + cell.first_node, values.begin() + cell.first_node + cell.nodes);
}

double most(const std::vector<double>& values, const CellState& cell) {
  return *std::max_element(values.begin() + cell.first_node, values.begin() + cell.first_node + cell.nodes);
}

TEST(Contact, SleepsWhereNothingIsNear) {
  State state = prepared_state(coarse_vessel_with_cells(2));
  const auto effect = contact.make(state);
  EXPECT_FALSE(effect->awake(state));
  effect->apply(state);
  EXPECT_EQ(state.counters.contact_steps, 0);
  EXPECT_TRUE(state.load.stiffness.empty());
  EXPECT_EQ(sum(state.load.fx), 0);
  EXPECT_EQ(sum(state.load.fy), 0);
}

TEST(Contact, IsAwakeBeforeAnythingCanTouch) {
  State state = prepared_state(coarse_vessel_with_cells());
  const CellState& cell = state.cells[0];
  const auto effect = contact.make(state);
  bool slept = false;
  while (least(state.particles.y, cell) > 0.1 * state.spacing) {
    const bool awake = effect->awake(state);
    slept = slept || !awake;
    std::fill(state.load.fy.begin(), state.load.fy.end(), 0.0);
    contact.make(state)->apply(state);
    EXPECT_TRUE(awake || sum(state.load.fy) == 0);
    move(state, cell, 0, -0.05 * state.spacing);
  }
  EXPECT_TRUE(slept);
  EXPECT_GT(state.counters.contact_steps, 0);
}

TEST(Contact, PushesOffAWallByTheDistanceFromIt) {
  State state = prepared_state(coarse_vessel_with_cells());
  const CellState& cell = state.cells[0];
  move(state, cell, 0, 0.2 * state.spacing - least(state.particles.y, cell));
  contact.make(state)->apply(state);
  EXPECT_EQ(state.counters.contact_steps, 1);
  EXPECT_GT(state.load.stiffness.size(), 0u);
  for (int i = 0; i < cell.nodes; ++i) {
    EXPECT_EQ(state.load.fx[i], 0);
    EXPECT_EQ(state.load.fy[i] > 0, state.particles.y[i] < 0.5 * state.spacing);
  }
}

TEST(Contact, PushesOffAThrombusAlongItsRadius) {
  Case scene = coarse_vessel_with_cells();
  scene.cells[0].diameter = 4e-6;
  scene.thrombi = {{Wall::lower, 8e-6, 3e-6}};
  State state = prepared_state(scene);
  const CellState& cell = state.cells[0];
  // Half a link aside, so that the crest is under the middle of one.
  const auto lowest = std::min_element(state.particles.y.begin(), state.particles.y.begin() + cell.nodes) -
                      state.particles.y.begin();
  move(state, cell, 0.8 + 0.5 * state.spacing - state.particles.x[lowest],
       0.3 + 0.2 * state.spacing - least(state.particles.y, cell));
  contact.make(state)->apply(state);
  EXPECT_EQ(state.counters.contact_steps, 1);
  double torque = 0;
  for (int i = 0; i < cell.nodes; ++i) {
    torque += (state.particles.x[i] - 0.8) * state.load.fy[i] - state.particles.y[i] * state.load.fx[i];
  }
  EXPECT_GT(sum(state.load.fy), 0);
  EXPECT_NEAR(torque, 0, 1e-12 * sum(state.load.fy));
}

TEST(Contact, BetweenCellsIsMutual) {
  State state = prepared_state(coarse_vessel_with_cells(2));
  const CellState &left = state.cells[0], &right = state.cells[1];
  move(state, right, most(state.particles.x, left) + 0.1 * state.spacing - least(state.particles.x, right),
       0);
  contact.make(state)->apply(state);
  double fx[2] = {}, fy[2] = {}, torque = 0;
  for (int i = 0; i < state.particles.membrane_end(); ++i) {
    const int side = i < right.first_node ? 0 : 1;
    fx[side] += state.load.fx[i];
    fy[side] += state.load.fy[i];
    torque += state.particles.x[i] * state.load.fy[i] - state.particles.y[i] * state.load.fx[i];
  }
  EXPECT_LT(fx[0], 0);
  EXPECT_NEAR(fx[0] + fx[1], 0, 1e-12 * fx[1]);
  EXPECT_NEAR(fy[0] + fy[1], 0, 1e-12 * fx[1]);
  EXPECT_NEAR(torque, 0, 1e-12 * fx[1]);
  EXPECT_EQ(state.counters.contact_steps, 1);
}

TEST(Contact, ActsAcrossASeamAsInTheMiddle) {
  const double touching = 3e-6;
  State middle = prepared_state(pair_around(10e-6, touching));
  State across = prepared_state(pair_around(0, touching));
  for (State* state : {&middle, &across}) contact.make(*state)->apply(*state);
  double strongest = 0;
  for (std::size_t q = 0; q < middle.load.fx.size(); ++q)
    strongest = std::max(strongest, std::abs(middle.load.fx[q]));
  ASSERT_GT(strongest, 0);
  ASSERT_EQ(middle.load.fx.size(), across.load.fx.size());
  for (std::size_t q = 0; q < middle.load.fx.size(); ++q) {
    EXPECT_NEAR(across.load.fx[q], middle.load.fx[q], 1e-9 * strongest);
    EXPECT_NEAR(across.load.fy[q], middle.load.fy[q], 1e-9 * strongest);
  }
}

}  // namespace
}  // namespace rouleau::effects
