#include "engine/observe/membrane_measures.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

/// m, between the nodes that face each other, of two cells side by side: cell 0 on the left.
double gap_of_facing_nodes(const effects::State& state) {
  const cells::Ring left = state.ring(state.cells[0]), right = state.ring(state.cells[1]);
  double gap =
      *std::min_element(right.x.begin(), right.x.end()) - *std::max_element(left.x.begin(), left.x.end());
  return (gap - state.periods_x(gap)) * state.scales.length;
}

TEST(CellGap, IsTheSameAcrossASeam) {
  const effects::State middle = effects::prepared_state(pair_around(10e-6));
  const effects::State across = effects::prepared_state(pair_around(0));
  const double gap = measure_membrane(middle, 0).cell_gap;
  // They stand upright, side by side and alike.
  EXPECT_NEAR(gap, gap_of_facing_nodes(middle), 0.01 * gap);
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_NEAR(measure_membrane(middle, k).cell_gap, gap, 1e-9 * gap);
    EXPECT_NEAR(measure_membrane(across, k).cell_gap, gap, 1e-9 * gap);
  }
}

TEST(CellGap, IsTheLeastOfThoseEitherWayRound) {
  Case scene = pair_around(10e-6);
  for (const double x : {7e-6, 12e-6, 17e-6}) {
    scene.cells[0].x = 3e-6;
    scene.cells[1].x = x;
    const double gap = measure_membrane(effects::prepared_state(scene), 0).cell_gap;
    scene.vessel.ends = Ends::open;
    const double direct = measure_membrane(effects::prepared_state(scene), 0).cell_gap;
    scene.vessel.ends = Ends::periodic;
    const double way = std::abs(x - 3e-6), around = 20e-6 - way;
    EXPECT_NEAR(gap - direct, std::min(around - way, 0.0), 1e-9 * way) << x;
  }
}

}  // namespace
}  // namespace rouleau::observe
