#include "engine/effects/thin_cells.h"

#include <gtest/gtest.h>

#include "engine/error/simulation_error.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// A cell that is squeezed to a fraction of its length across the vessel.
State squeezed(Refine refine, double factor) {
  Case scene = coarse_vessel_with_cells();
  scene.numerics.refine = refine;
  State state = prepared_state(scene);
  const CellState& cell = state.cells[0];
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i)
    state.particles.x[i] = 0.8 + factor * (state.particles.x[i] - 0.8);
  return state;
}

TEST(ThinCells, CallForAFinerSpacing) {
  State state = squeezed(Refine::automatic, 1.2);
  thin_cells.make(state)->apply(state);
  EXPECT_EQ(state.wanted_spacing, 0);
  state = squeezed(Refine::automatic, 0.5);
  thin_cells.make(state)->apply(state);
  EXPECT_GT(state.wanted_spacing, 0);
  EXPECT_LT(state.wanted_spacing, 0.8 * state.spacing);
  EXPECT_EQ(state.thinnest_cell, 0);
}

TEST(ThinCells, EndARunThatMayNotTakeOne) {
  State state = squeezed(Refine::off, 0.5);
  EXPECT_THROW(thin_cells.make(state)->apply(state), SimulationError);
}

TEST(ThinCells, AreLetGoOfBeforeAnOutlet) {
  for (const Refine refine : {Refine::automatic, Refine::off}) {
    State state = squeezed(refine, 0.5);
    state.cells[0].presence = 0.99;
    EXPECT_NO_THROW(thin_cells.make(state)->apply(state));
    EXPECT_EQ(state.wanted_spacing, 0);
  }
}

}  // namespace
}  // namespace rouleau::effects
