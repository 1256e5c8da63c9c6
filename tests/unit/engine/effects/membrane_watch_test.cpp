#include "engine/effects/membrane_watch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "engine/cells/ring.h"
#include "engine/error/simulation_error.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

/// Of cell 1, about the middle of its nodes.
void scale(State& state, double along, double across) {
  const CellState& cell = state.cells[1];
  double x = 0, y = 0;
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) {
    x += state.particles.x[i] / cell.nodes;
    y += state.particles.y[i] / cell.nodes;
  }
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) {
    state.particles.x[i] = x + along * (state.particles.x[i] - x);
    state.particles.y[i] = y + across * (state.particles.y[i] - y);
  }
}

TEST(MembraneWatch, LetsWholeCellsPassAndNotesTheirExtremes) {
  State state = prepared_state(coarse_vessel_with_cells(2));
  membrane_watch.make(state)->apply(state);
  EXPECT_NEAR(state.counters.cells[1].area_drift, 0, 1e-12);
  const double thickness = cells::thickness(state.ring(state.cells[1])) / state.spacing;
  EXPECT_DOUBLE_EQ(state.counters.cells[1].least_thickness, thickness);
  scale(state, 1.0005, 1.0005);
  membrane_watch.make(state)->apply(state);
  EXPECT_NEAR(state.counters.cells[1].area_drift, 0.001, 1e-6);
  EXPECT_NEAR(state.counters.cells[1].most_perimeter, 1.0005, 1e-9);
  EXPECT_EQ(state.counters.cells[0].most_perimeter, 1);
  EXPECT_DOUBLE_EQ(state.counters.cells[1].least_thickness, thickness);
}

struct Harm {
  const char* name;
  const char* quantity;
  double value;
  bool mendable;
  std::function<void(State&)> harm;
};

class MembraneWatchStops : public testing::TestWithParam<Harm> {};

TEST_P(MembraneWatchStops, AndNamesTheCell) {
  State state = prepared_state(coarse_vessel_with_cells(2));
  state.step = 41;
  GetParam().harm(state);
  try {
    membrane_watch.make(state)->apply(state);
    FAIL() << "went on";
  } catch (const SimulationError& error) {
    const Breach& breach = error.breach();
    EXPECT_EQ(breach.quantity, GetParam().quantity);
    EXPECT_NEAR(breach.value, GetParam().value, 1e-9);
    EXPECT_EQ(breach.cell, 1);
    EXPECT_EQ(breach.mendable, GetParam().mendable);
    EXPECT_EQ(breach.particle, -1);
    EXPECT_EQ(breach.step, 42);
    EXPECT_NEAR(breach.x, 17e-6, 3e-6);
    EXPECT_NEAR(breach.y, 5e-6, 5e-6);
  }
}

/// Node 3 of cell 1 to the far side of the cell.
void cross(State& state) {
  const CellState& cell = state.cells[1];
  const int node = cell.first_node + 3, opposite = cell.first_node + (3 + cell.nodes / 2) % cell.nodes;
  auto& p = state.particles;
  p.x[node] += 1.2 * (p.x[opposite] - p.x[node]);
  p.y[node] += 1.2 * (p.y[opposite] - p.y[node]);
  state.cells[1].start_area = cells::area(state.ring(state.cells[1]));
}

INSTANTIATE_TEST_SUITE_P(Harms, MembraneWatchStops,
                         testing::Values(Harm{"Jumps", "change of a cell's area in a step", 0.0201, true,
                                              [](State& s) { scale(s, 1.01, 1.01); }},
                                         Harm{"Swells", "change of a cell's area", 0.0404, false,
                                              [](State& s) {
                                                s.counters.cells[1].area = 1.04;
                                                scale(s, 1.02, 1.02);
                                              }},
                                         Harm{"Shrinks", "change of a cell's area", 0.0396, false,
                                              [](State& s) {
                                                s.counters.cells[1].area = 0.96;
                                                scale(s, 0.98, 0.98);
                                              }},
                                         Harm{"Lengthens", "perimeter over that at the start", 12, false,
                                              [](State& s) { s.cells[1].start_perimeter /= 12; }},
                                         Harm{"Collapses", "perimeter over that at the start", 0.4, false,
                                              [](State& s) { s.cells[1].start_perimeter /= 0.4; }},
                                         Harm{"Crosses", "crossing membrane edges", 1, true, cross}),
                         [](const auto& harm) { return std::string(harm.param.name); });

TEST(MembraneWatch, SeesTwoMembranesCross) {
  State state = prepared_state(coarse_vessel_with_cells(2));
  const CellState& cell = state.cells[1];
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i) state.particles.x[i] -= 0.85;
  EXPECT_THROW(membrane_watch.make(state)->apply(state), SimulationError);
}

/// What the watch says of two cells beside a seam, the right one of which is moved along x by a part of the
/// vessel's length.
std::optional<Breach> breach_at_the_seam(double along) {
  State state = prepared_state(pair_around(0));
  const CellState& cell = state.cells[1];
  for (int i = cell.first_node; i < cell.first_node + cell.nodes; ++i)
    state.particles.x[i] += along * state.outline.period_x();
  try {
    membrane_watch.make(state)->apply(state);
  } catch (const SimulationError& error) {
    return error.breach();
  }
  return std::nullopt;
}

TEST(MembraneWatch, SeesTwoMembranesCrossAtASeam) {
  EXPECT_FALSE(breach_at_the_seam(0));
  const auto breach = breach_at_the_seam(-0.075);
  ASSERT_TRUE(breach);
  EXPECT_EQ(breach->quantity, "crossing membrane edges");
  EXPECT_GE(breach->x, 17e-6) << "in the vessel, where the left one is";
  EXPECT_LT(breach->x, 20e-6);
}

TEST(MembraneWatch, SeesACellMeetItsOwnImage) {
  Case scene = pair_around(10e-6);
  scene.cells.pop_back();
  State state = prepared_state(scene);
  CellState& cell = state.cells[0];
  const double middle = scene.cells[0].x / state.scales.length;
  double x0 = 1e300, x1 = -1e300;
  for (int i = 0; i < cell.nodes; ++i) {
    x0 = std::min(x0, state.particles.x[i]);
    x1 = std::max(x1, state.particles.x[i]);
  }
  const auto make_long = [&](double periods) {
    const double factor = periods * state.outline.period_x() / (x1 - x0);
    for (int i = 0; i < cell.nodes; ++i)
      state.particles.x[i] = middle + factor * (state.particles.x[i] - middle);
    x0 = middle + factor * (x0 - middle);
    x1 = middle + factor * (x1 - middle);
    cell.start_area = cells::area(state.ring(cell));
    cell.start_perimeter = cells::perimeter(state.ring(cell));
  };
  make_long(0.99);
  EXPECT_NO_THROW(membrane_watch.make(state)->apply(state));
  make_long(1.01);
  EXPECT_THROW(membrane_watch.make(state)->apply(state), SimulationError);
}

TEST(MembraneWatch, TakesACellThatIsNotANumberForABreach) {
  State state = prepared_state(coarse_vessel_with_cells(1));
  state.particles.y[2] = std::nan("");
  EXPECT_THROW(membrane_watch.make(state)->apply(state), SimulationError);
}

}  // namespace
}  // namespace rouleau::effects
