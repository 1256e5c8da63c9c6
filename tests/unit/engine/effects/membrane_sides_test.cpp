#include "engine/effects/membrane_sides.h"

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// A cell across the seam of a periodic vessel: its nodes reach below x = 0, and half of the particles that
/// it encloses are at the other end.
State across_the_seam() {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.ends = Ends::periodic;
  scene.cells[0].x = 0;
  return prepared_state(scene);
}

TEST(MembraneSides, LookForParticlesAcrossTheSeamOfAPeriodicVessel) {
  State state = across_the_seam();
  const auto effect = membrane_sides.make(state);
  effect->apply(state);
  EXPECT_EQ(state.counters.wrong_side, 0);
  auto& particles = state.particles;
  int far = -1;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    if (particles.cell[i] == 0 && particles.x[i] > 0.5) far = i;
  }
  ASSERT_GE(far, 0) << "nothing of the cell is at the other end";
  const double period = state.outline.period_x();
  const cells::Ring ring = state.ring(state.cells[0]);
  ASSERT_TRUE(cells::contains(ring, particles.x[far] - period, particles.y[far]));
  // Pushed through the nearest link, by a tenth of a spacing.
  const cells::Nearest link = cells::nearest(ring, particles.x[far] - period, particles.y[far]);
  particles.x[far] = period + link.x + 0.1 * state.spacing * link.nx;
  particles.y[far] = link.y + 0.1 * state.spacing * link.ny;
  ASSERT_FALSE(cells::contains(ring, particles.x[far] - period, particles.y[far]));
  effect->apply(state);
  EXPECT_EQ(state.counters.wrong_side, 1);
  EXPECT_GT(particles.x[far], 0.5);
  EXPECT_TRUE(cells::contains(ring, particles.x[far] - period, particles.y[far]));
}

// The cell is a fiftieth of a spacing thick: a tenth of one behind the link is out on the other side again.
TEST(MembraneSides, PutParticlesBackIntoTheThinnestCells) {
  State state = prepared_state(coarse_vessel_with_cells());
  auto& particles = state.particles;
  const CellState& cell = state.cells[0];
  const double d0 = state.spacing, x0 = cells::measure(state.ring(cell)).x;
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) {
    const bool left = i - cell.first_node < cell.nodes / 2;
    const int along = left ? i - cell.first_node : cell.first_node + cell.nodes - 1 - i;
    particles.x[i] = x0 + (left ? -0.025 : 0.025) * d0;
    particles.y[i] = 0.7 - 0.4 * along * 2 / cell.nodes;
  }
  int lost = -1;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    if (particles.cell[i] != 0) continue;
    if (lost < 0) lost = i;
    particles.x[i] = x0;
    particles.y[i] = 0.5;
  }
  particles.x[lost] = x0 + 0.2 * d0;
  ASSERT_TRUE(cells::contains(state.ring(cell), x0, 0.5));
  membrane_sides.make(state)->apply(state);
  EXPECT_EQ(state.counters.wrong_side, 1);
  EXPECT_TRUE(cells::contains(state.ring(cell), particles.x[lost], particles.y[lost]));
}

}  // namespace
}  // namespace rouleau::effects
