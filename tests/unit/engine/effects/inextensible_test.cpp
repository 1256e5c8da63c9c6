#include "engine/effects/inextensible.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/case/presets.h"
#include "engine/cells/ring.h"
#include "engine/effects/length_control.h"
#include "engine/effects/stretch.h"
#include "engine/error/simulation_error.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

Case inextensible_cell() {
  Case scene = coarse_vessel_with_cells();
  scene.effects["inextensible"] = Switch::on;
  return scene;
}

TEST(Inextensible, IsOffUnlessAskedForAndThenStandsInForStretch) {
  const Case scene = coarse_vessel_with_cells(), held = inextensible_cell();
  EXPECT_FALSE(inextensible.need(scene).called_for);
  EXPECT_TRUE(inextensible.need(scene).on_request);
  EXPECT_TRUE(stretch.need(scene).called_for);
  EXPECT_FALSE(length_control.need(scene).called_for);
  EXPECT_FALSE(stretch.need(held).called_for);
  EXPECT_TRUE(length_control.need(held).called_for);
}

TEST(Inextensible, NeedsCellsThatKeepTheirAreaAndTheAccurateScheme) {
  Case published = coarse_vessel_with_cells();
  published.numerics = preset_numerics(Preset::paper);
  Case deflating = coarse_vessel_with_cells();
  deflating.cells[0].shape = CellShape::circle;
  for (const Case& scene : {coarse_vessel(), published, deflating}) {
    const Need need = inextensible.need(scene);
    EXPECT_FALSE(need.called_for || need.on_request);
    EXPECT_FALSE(need.reason.empty());
  }
}

/// A state whose next positions are where the nodes are, each link held as it is.
State held_state() {
  State state = prepared_state(inextensible_cell());
  state.next_x = state.particles.x;
  state.next_y = state.particles.y;
  CellState& cell = state.cells[0];
  cell.held = cells::hold_links(state.ring(cell), cell.material);
  return state;
}

cells::Ring next_ring(const State& state) {
  const auto nodes = static_cast<std::size_t>(state.cells[0].nodes);
  return {{state.next_x.data(), nodes}, {state.next_y.data(), nodes}};
}

TEST(LengthControl, LeavesLinksThatHaveTheirLengthsAlone) {
  State state = held_state();
  length_control.make(state)->apply(state);
  EXPECT_EQ(state.next_x, state.particles.x);
  EXPECT_EQ(state.next_y, state.particles.y);
}

TEST(LengthControl, GivesEveryLinkItsLengthByASmallMoveThatTurnsNothing) {
  State state = held_state();
  const auto nodes = static_cast<std::size_t>(state.cells[0].nodes);
  double moved = 0, x = 0, y = 0, turn = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    state.next_x[i] += 0.05 * state.spacing * std::sin(7.0 * static_cast<double>(i));
    state.next_y[i] += 0.05 * state.spacing * std::cos(5.0 * static_cast<double>(i));
  }
  const auto before_x = state.next_x, before_y = state.next_y;
  const double area = cells::area(next_ring(state));
  ASSERT_GT(cells::greatest_length_error(next_ring(state), state.cells[0].held), 0.05);
  length_control.make(state)->apply(state);
  EXPECT_LT(cells::greatest_length_error(next_ring(state), state.cells[0].held), 1e-9);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double dx = state.next_x[i] - before_x[i], dy = state.next_y[i] - before_y[i];
    moved = std::max(moved, std::hypot(dx, dy));
    x += dx;
    y += dy;
    turn += before_x[i] * dy - before_y[i] * dx;
  }
  EXPECT_LT(moved, 0.15 * state.spacing);
  EXPECT_NEAR(cells::area(next_ring(state)), area, 1e-3 * area);
  EXPECT_NEAR(x, 0, 1e-12);
  EXPECT_NEAR(y, 0, 1e-12);
  EXPECT_LT(std::abs(turn), 0.01 * moved * static_cast<double>(nodes));
}

TEST(LengthControl, HasAStepThatTearsAMembraneTakenAgain) {
  State state = held_state();
  for (int i = 0; i < state.cells[0].nodes; i += 2) state.next_x[i] += 3 * state.spacing;
  try {
    length_control.make(state)->apply(state);
    FAIL();
  } catch (const SimulationError& error) {
    EXPECT_TRUE(error.breach().mendable);
    EXPECT_EQ(error.breach().cell, 0);
  }
}

TEST(Inextensible, EveryLinkKeepsItsLengthStepByStep) {
  Case scene = inextensible_cell();
  scene.vessel.length = 40e-6;  // its end is far
  Simulation simulation(scene);
  const CellState& cell = simulation.state().cells[0];
  double most = 0;
  for (int k = 0; k < 12; ++k) {
    simulation.step();
    most = std::max(most, cells::greatest_length_error(simulation.state().ring(cell), cell.held));
  }
  EXPECT_LT(most, 1e-9);
  EXPECT_NEAR(cells::perimeter(simulation.state().ring(cell)), cell.start_perimeter,
              1e-9 * cell.start_perimeter);
  const auto [least, greatest] = std::minmax_element(cell.held.tension.begin(), cell.held.tension.end());
  EXPECT_GT(*greatest - *least, 0);
}

TEST(Inextensible, KeepsNothingWhereItIsNotCalledFor) {
  Simulation simulation(coarse_vessel_with_cells());
  simulation.step();
  EXPECT_EQ(simulation.state().cells[0].held, cells::HeldLinks{});
}

/// Nodes placed anew begin with the lengths that they then have.
TEST(Inextensible, GoesOnAtAFinerSpacing) {
  Case scene = inextensible_cell();
  scene.numerics.refine = Refine::automatic;
  scene.cells[0].fill = 0.45;
  Simulation simulation(scene);
  for (int k = 0; k < 12 && simulation.refinements().empty(); ++k) simulation.step();
  ASSERT_FALSE(simulation.refinements().empty());
  for (int k = 0; k < 5; ++k) simulation.step();
  const CellState& cell = simulation.state().cells[0];
  ASSERT_EQ(cell.held.length.size(), static_cast<std::size_t>(cell.nodes));
  EXPECT_LT(cells::greatest_length_error(simulation.state().ring(cell), cell.held), 1e-9);
}

}  // namespace
}  // namespace rouleau::effects
