#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

constexpr double length = 20e-6;
constexpr double fastest = 0.016;

/// A cell in shear between walls that also carry it along.
Case sheared_cell(double x) {
  Case scene = coarse_vessel_with_cells();
  scene.vessel = {length, 12e-6};
  scene.vessel.ends = Ends::periodic;
  scene.vessel.wall_velocity = {0.004, fastest, 0, 0};
  scene.cells[0].x = x;
  scene.cells[0].y = 6.5e-6;
  scene.cells[0].angle = 60;
  return scene;
}

/// What a quantity is to be compared with: velocities with the walls', rates with the shear's, strains
/// with 1.
double scale_of(const std::string& unit, double value) {
  if (unit == "m/s") return fastest;
  if (unit == "1/s") return 1000;
  return unit == "1" ? std::max(1.0, std::abs(value)) : std::abs(value);
}

// Half the period is a whole number of bins, of columns and of the squares of the coarse spaces, so both runs
// are the same but for rounding.
TEST(PeriodicCells, BehaveAcrossTheSeamAsInTheMiddle) {
  Recorder middle, across;
  const RunSummary in_middle = run_case(sheared_cell(8e-6), middle);
  const RunSummary over_seam = run_case(sheared_cell(18e-6), across);
  ASSERT_GT(middle.rows.size(), 5u);
  ASSERT_EQ(middle.rows.size(), across.rows.size());
  const auto& columns = middle.header.columns;
  bool crossed = false;
  for (std::size_t row = 0; row < middle.rows.size(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::string& name = columns[c].name;
      if (name.rfind("cell0.", 0) != 0) continue;
      const double value = middle.rows[row][c], other = across.rows[row][c];
      if (name == "cell0.x") {
        EXPECT_GE(other, 0);
        EXPECT_LT(other, length);
        EXPECT_NEAR(std::remainder(other - value - length / 2, length), 0, 1e-6 * length);
        crossed = crossed || other < length / 2;
      } else {
        const double scale = scale_of(columns[c].unit, value);
        EXPECT_NEAR(other, value, 1e-6 * scale) << name << ", row " << row;
      }
    }
  }
  EXPECT_TRUE(crossed);
  EXPECT_EQ(over_seam.wrong_side, in_middle.wrong_side);
}

/// Fluid particles that are not where their cell is, images considered.
int misplaced(const effects::State& state) {
  const auto& particles = state.particles;
  const double px = state.outline.period_x(), py = state.outline.period_y();
  const cells::Ring ring = state.ring(state.cells[0]);
  int count = 0;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    bool inside = false;
    for (const double a : {-px, 0.0, px}) {
      for (const double b : {-py, 0.0, py}) {
        inside = inside || cells::contains(ring, particles.x[i] + a, particles.y[i] + b);
      }
    }
    count += inside != (particles.cell[i] == 0);
  }
  return count;
}

TEST(PeriodicCells, HoldTheirFluidOverBothSeamsOfAPeriodicBox) {
  Case scene = coarse_vessel_with_cells();
  scene.vessel = {14e-6, 14e-6};
  scene.vessel.shape = Shape::box;
  scene.vessel.ends = Ends::periodic;
  scene.initial = {InitialFlow::taylor_green, 0.01};
  scene.cells[0].x = 0;
  scene.cells[0].y = 0;
  Simulation simulation(scene);
  const effects::State& state = simulation.state();
  EXPECT_EQ(misplaced(state), 0);
  while (!simulation.finished()) simulation.step();
  EXPECT_EQ(misplaced(state), 0);
  const cells::Shape shape = cells::measure(state.ring(state.cells[0]));
  EXPECT_NEAR(shape.area, state.cells[0].start_area, 0.005 * state.cells[0].start_area);
}

}  // namespace
}  // namespace rouleau
