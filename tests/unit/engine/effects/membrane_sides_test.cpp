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

}  // namespace
}  // namespace rouleau::effects
