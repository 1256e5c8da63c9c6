#include "engine/simulation/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "engine/cells/resample.h"
#include "engine/cells/shape.h"
#include "engine/error/simulation_error.h"
#include "engine/observe/first_nodes.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

/// A vessel of 10 x 2.5 cells' diameters, some steps after the start.
class Refined : public testing::Test {
 protected:
  Refined() : simulation_(coarse_vessel_with_cells()) {
    for (int k = 0; k < 5; ++k) simulation_.step();
  }

  const effects::State& before() const { return simulation_.state(); }

  static std::array<double, 2> momentum(const effects::State& state) {
    std::array<double, 2> sum{};
    for (int i = 0; i < state.particles.size(); ++i) {
      if (state.particles.group[i] > particles::Group::fluid) continue;
      sum[0] += state.particles.u[i] * state.spacing * state.spacing;
      sum[1] += state.particles.v[i] * state.spacing * state.spacing;
    }
    return sum;
  }

  Simulation simulation_;
};

TEST_F(Refined, CellsKeepTheirAreaPlaceAndStretchingEnergy) {
  const effects::State after = refined(before(), before().spacing / 2);
  ASSERT_EQ(after.cells.size(), 1u);
  const effects::CellState &old_cell = before().cells[0], &cell = after.cells[0];
  EXPECT_GT(cell.nodes, 1.5 * old_cell.nodes);
  const cells::Shape old_shape = cells::measure(before().ring(old_cell)),
                     shape = cells::measure(after.ring(cell));
  EXPECT_NEAR(shape.area, old_shape.area, 1e-9 * old_shape.area);
  EXPECT_NEAR(shape.x, old_shape.x, 2e-3);
  EXPECT_NEAR(shape.y, old_shape.y, 2e-3);
  EXPECT_NEAR(shape.perimeter, old_shape.perimeter, 0.02 * old_shape.perimeter);
  const double rest =
      std::accumulate(cell.material.rest_lengths.begin(), cell.material.rest_lengths.end(), 0.0);
  EXPECT_NEAR(rest, old_cell.material.rest_length * old_cell.nodes, 1e-12);
}

TEST_F(Refined, PlasmaKeepsItsMomentum) {
  const effects::State after = refined(before(), before().spacing / 2);
  const auto old_momentum = momentum(before()), new_momentum = momentum(after);
  EXPECT_NEAR(new_momentum[0], old_momentum[0], 1e-12);
  EXPECT_NEAR(new_momentum[1], old_momentum[1], 1e-12);
}

TEST_F(Refined, TheNodesOfBeforeAreFoundAgain) {
  const effects::State after = refined(before(), before().spacing / 2);
  const observe::FirstNodes nodes = observe::first_nodes(after, after.cells[0]);
  ASSERT_EQ(nodes.x.size(), static_cast<std::size_t>(before().cells[0].nodes));
  for (std::size_t q = 0; q < nodes.x.size(); ++q) {
    EXPECT_NEAR(nodes.x[q], before().particles.x[q], 0.2 * before().spacing);
    EXPECT_NEAR(nodes.y[q], before().particles.y[q], 0.2 * before().spacing);
  }
}

TEST_F(Refined, NodesAnewLeaveAllElseAsItIs) {
  effects::State after = before();
  const effects::CellState old_cell = before().cells[0];
  auto& particles = after.particles;
  for (int q = 0; q < old_cell.nodes; ++q) particles.y[q] = 0.5 + 1.3 * (particles.y[q] - 0.5);
  const double area = cells::area(after.ring(old_cell)), perimeter = cells::perimeter(after.ring(old_cell));
  renew_nodes(after);
  const effects::CellState& cell = after.cells[0];
  EXPECT_EQ(cell.nodes, std::lround(perimeter / after.spacing));
  const auto lengths = cells::link_lengths(after.ring(cell));
  EXPECT_NEAR(*std::ranges::min_element(lengths), after.spacing, 0.1 * after.spacing);
  EXPECT_NEAR(*std::ranges::max_element(lengths), after.spacing, 0.1 * after.spacing);
  EXPECT_NEAR(cells::area(after.ring(cell)), area, 1e-9 * area);
  const auto& old = before().particles;
  const int more = particles.size() - old.size();
  EXPECT_EQ(more, cell.nodes - old_cell.nodes);
  for (int i = old.membrane_end(); i < old.size(); ++i) {
    EXPECT_EQ(particles.id[i + more], old.id[i]);
    EXPECT_EQ(particles.x[i + more], old.x[i]);
    EXPECT_EQ(particles.u[i + more], old.u[i]);
    EXPECT_EQ(particles.p[i + more], old.p[i]);
    EXPECT_EQ(particles.cell[i + more], old.cell[i]);
    EXPECT_EQ(particles.group[i + more], old.group[i]);
  }
}

/// Limp as a soap film: the perimeter doubles within a vessel's length.
Case limp_cell(Refine refine) {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.length = 40e-6;
  scene.numerics.spacing = 5e-7;
  scene.numerics.refine = refine;
  scene.cells[0].stretch_modulus = 1e-7;
  scene.cells[0].bend_modulus = 4.8e-20;
  scene.duration = 4e-3;
  return scene;
}

TEST(ThinCells, AreComputedWithFinerSpacings) {
  Simulation simulation(limp_cell(Refine::automatic));
  while (!simulation.finished() && simulation.state().spacing == simulation.state().start_spacing)
    simulation.step();
  ASSERT_FALSE(simulation.refinements().empty());
  EXPECT_LT(simulation.state().spacing, simulation.state().start_spacing);
  EXPECT_EQ(simulation.refinements().front().cell, 0);
  EXPECT_EQ(simulation.state().counters.wrong_side, 0);
  const double area = cells::area(simulation.state().ring(simulation.state().cells[0]));
  EXPECT_NEAR(area, simulation.state().cells[0].start_area, 0.005 * area);
}

TEST(ThinCells, EndARunThatMayNotRefine) {
  Simulation simulation(limp_cell(Refine::off));
  try {
    while (!simulation.finished()) simulation.step();
    FAIL() << "it went on";
  } catch (const SimulationError& error) {
    EXPECT_EQ(error.breach().quantity, "mean thickness of a cell");
    EXPECT_EQ(error.breach().cell, 0);
    EXPECT_NE(error.breach().advice.find("would do"), std::string::npos);
    EXPECT_GT(error.breach().time, 0);
  }
}

}  // namespace
}  // namespace rouleau
