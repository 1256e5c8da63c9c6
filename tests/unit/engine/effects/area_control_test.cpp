#include "engine/effects/area_control.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// Before its first motion, with a cell that is to have another area than it has.
State drifted(double wanted) {
  State state = prepared_state(coarse_vessel_with_cells());
  state.next_x = state.particles.x;
  state.next_y = state.particles.y;
  state.cells[0].start_area *= wanted;
  return state;
}

double next_area(const State& state) {
  const auto first = static_cast<std::size_t>(state.cells[0].first_node);
  const auto nodes = static_cast<std::size_t>(state.cells[0].nodes);
  return cells::area({{state.next_x.data() + first, nodes}, {state.next_y.data() + first, nodes}});
}

// To first order in the coarse ring's links.
TEST(AreaControl, UndoesADriftWithinItsRelaxationTime) {
  for (const double wanted : {0.999, 1.001}) {
    State state = drifted(wanted);
    const double before = next_area(state);
    state.dt = 0.001;
    area_control.make(state)->apply(state);
    EXPECT_NEAR((next_area(state) - before) / (state.cells[0].start_area - before), 0.1, 3e-3);
  }
}

TEST(AreaControl, MovesNoNodeFarAndNothingElse) {
  State state = drifted(1.5);
  state.dt = 1;
  area_control.make(state)->apply(state);
  const auto& p = state.particles;
  for (int i = 0; i < p.size(); ++i) {
    const double way = std::hypot(state.next_x[i] - p.x[i], state.next_y[i] - p.y[i]);
    if (i < p.membrane_end()) {
      EXPECT_NEAR(way, 0.01 * state.spacing, 1e-12);
    } else {
      EXPECT_EQ(way, 0);
    }
  }
}

TEST(AreaControl, DoesNothingInNoTime) {
  State state = drifted(1.5);
  state.dt = 0;
  area_control.make(state)->apply(state);
  EXPECT_EQ(state.next_x, state.particles.x);
  EXPECT_EQ(state.next_y, state.particles.y);
}

}  // namespace
}  // namespace rouleau::effects
