#include "engine/effects/neighbourhood.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// Looked for from the side of every particle.
std::vector<int> around_by_all(const State& state, const std::vector<int>& seeds) {
  std::vector<int> found;
  for (int i = 0; i < state.particles.active_end(); ++i) {
    bool near = std::count(seeds.begin(), seeds.end(), i) > 0;
    for (int k = state.neighbours.begin(i); k < state.neighbours.end(i); ++k) {
      near = near || std::count(seeds.begin(), seeds.end(), state.neighbours.j[k]) > 0;
    }
    if (near) found.push_back(i);
  }
  return found;
}

TEST(Neighbourhood, IsWhatEveryParticleFindsItself) {
  const State state = prepared_state(coarse_vessel_with_cells(2));
  Neighbourhood neighbourhood;
  for (const CellState& cell : state.cells) {
    std::vector<int> nodes;
    for (int q = 0; q < cell.nodes; ++q) nodes.push_back(cell.first_node + q);
    const std::vector<int> once = around_by_all(state, nodes), twice = around_by_all(state, once);
    EXPECT_EQ(neighbourhood.around(state, nodes), once);
    EXPECT_EQ(neighbourhood.around(state, nodes_of(cell)), once);
    EXPECT_EQ(neighbourhood.around(state, nodes, 2), twice);
    EXPECT_LT(once.size(), twice.size());
  }
  EXPECT_TRUE(neighbourhood.around(state, std::vector<int>{}).empty());
}

}  // namespace
}  // namespace rouleau::effects
