#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/effects/membrane_coupling.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// Two round cells a tenth of a spacing apart: there is no plasma between them, and each one's fluid is among
/// the neighbours of the other's.
class TwoMembranes : public testing::Test {
 protected:
  TwoMembranes() : state_(prepared_state(two_cells())) {}

  static Case two_cells() {
    Case scene = coarse_vessel();
    scene.vessel.length = 20e-6;
    scene.numerics.spacing = 0.5e-6;
    for (const double x : {6e-6, 6e-6 + 6.36e-6 + 0.05e-6}) {
      RedCell cell;
      cell.x = x;
      cell.y = 5e-6;
      cell.fill = 0.999;
      scene.cells.push_back(cell);
    }
    return scene;
  }

  double colour(int c, int i) const {
    if (state_.particles.cell[i] != c) return 0;
    return i < state_.particles.membrane_end() ? 0.5 : 1;
  }

  /// A tension that a jump of pressure `jump` balances.
  void load(int c, double jump, bool along) {
    const CellState& cell = state_.cells[c];
    const auto& p = state_.particles;
    for (int q = 0; q < cell.nodes; ++q) {
      const int node = cell.first_node + q;
      const int before = cell.first_node + (q + cell.nodes - 1) % cell.nodes;
      const int after = cell.first_node + (q + 1) % cell.nodes;
      // Half the chord, along it and outwards.
      const double tx = (p.x[after] - p.x[before]) / 2, ty = (p.y[after] - p.y[before]) / 2;
      state_.load.fx[node] = jump * (along ? tx : -ty);
      state_.load.fy[node] = jump * (along ? ty : tx);
    }
  }

  State state_;
};

TEST_F(TwoMembranes, EachBalancesItsOwnJumpOfPressure) {
  for (const auto& jump : {std::array{100.0, 0.0}, std::array{0.0, 100.0}, std::array{100.0, -60.0}}) {
    auto& p = state_.particles;
    std::fill(state_.ax.begin(), state_.ax.end(), 0);
    std::fill(state_.ay.begin(), state_.ay.end(), 0);
    for (int c = 0; c < 2; ++c) load(c, jump[c], false);
    for (int i = 0; i < p.active_end(); ++i) p.p[i] = jump[0] * colour(0, i) + jump[1] * colour(1, i);
    membrane_coupling.make(state_)->apply(state_);
    double slope = 0, left = 0;
    for (int i = 0; i < p.active_end(); ++i) {
      const auto gradient = state_.operators.pressure_gradient(i, p.p.data());
      slope = std::max(slope, std::hypot(gradient.x, gradient.y));
      left = std::max(left, std::hypot(state_.ax[i] - gradient.x, state_.ay[i] - gradient.y));
    }
    EXPECT_GT(slope, 100 / state_.spacing / 4);
    EXPECT_LT(left, 1e-6 * slope);
  }
}

TEST_F(TwoMembranes, AreNotDraggedByOneAnother) {
  load(0, 100, true);
  membrane_coupling.make(state_)->apply(state_);
  double given = 0, dragged = 0;
  for (int i = 0; i < state_.particles.active_end(); ++i) {
    double& most = state_.particles.cell[i] == 1 ? dragged : given;
    most = std::max(most, std::hypot(state_.ax[i], state_.ay[i]));
  }
  EXPECT_GT(given, 0);
  EXPECT_LT(dragged, 1e-12 * given);
}

}  // namespace
}  // namespace rouleau::effects
