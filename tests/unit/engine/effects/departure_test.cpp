#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

constexpr double spacing = 0.5e-6;

/// A cell 2 um before where it begins to fade, and room for another behind it.
Case vessel_that_a_cell_leaves(int cells = 1) {
  Case scene = coarse_vessel();
  scene.vessel.length = 30e-6;
  scene.numerics.spacing = spacing;
  scene.duration = 2.2e-3;
  scene.output = {2e-5, 2e-4};
  for (const double x : {19e-6, 12e-6}) {
    RedCell cell;
    cell.x = x;
    cell.y = 5e-6;
    if (scene.cells.size() < static_cast<std::size_t>(cells)) scene.cells.push_back(cell);
  }
  return scene;
}

struct Flow : Recorder {
  std::vector<double> column(const std::string& name) const {
    const auto found = std::find_if(header.columns.begin(), header.columns.end(),
                                    [&](const Column& column) { return column.name == name; });
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row.at(found - header.columns.begin()));
    return values;
  }
};

bool no_membrane(const Frame& frame) {
  return std::all_of(frame.kind.begin(), frame.kind.end(),
                     [](ParticleKind kind) { return kind == ParticleKind::plasma; });
}

TEST(Departure, ACellLeavesWithoutATraceInTheFlow) {
  Flow with_cell, plasma;
  Case scene = vessel_that_a_cell_leaves();
  const RunSummary summary = run_case(scene, with_cell);
  scene.cells.clear();
  run_case(scene, plasma);

  EXPECT_EQ(summary.ending, Ending::completed);
  ASSERT_TRUE(summary.cells[0].departure);
  EXPECT_EQ(summary.cells[0].departure->outlet, 0);
  const double left = summary.cells[0].departure->time;
  const auto time = with_cell.column("time"), x = with_cell.column("cell0.x");
  for (std::size_t k = 0; k < time.size(); ++k) EXPECT_EQ(std::isnan(x[k]), time[k] >= left) << time[k];
  EXPECT_TRUE(no_membrane(with_cell.frames.back()));

  // What the cell displaces on its way is measured at this coarse spacing, too: 0.5 % of the flux.
  const auto out = with_cell.column("outflow"), drop = with_cell.column("pressure_drop");
  const double flux = scene.inflow.velocity * scene.vessel.diameter;
  for (std::size_t k = 10; k < out.size(); ++k) EXPECT_NEAR(out[k], flux, 0.01 * flux) << time[k];
  const auto plasma_drop = plasma.column("pressure_drop");
  EXPECT_GT(drop[20], 1.02 * plasma_drop[20]);
  EXPECT_NEAR(drop.back(), plasma_drop.back(), 0.005 * plasma_drop.back());
  for (std::size_t k = 11; k < drop.size(); ++k) EXPECT_NEAR(drop[k], drop[k - 1], 0.02 * drop[k]) << time[k];
}

TEST(Departure, TheOtherCellsStayAsTheyAre) {
  Flow both;
  Case scene = vessel_that_a_cell_leaves(2);
  scene.duration = 1.6e-3;
  const RunSummary summary = run_case(scene, both);
  ASSERT_TRUE(summary.cells[0].departure);
  EXPECT_FALSE(summary.cells[1].departure);
  EXPECT_LT(summary.cells[1].area_deviation, 0.005);
  const auto x = both.column("cell1.x"), perimeter = both.column("cell1.perimeter");
  for (std::size_t k = 1; k < x.size(); ++k) {
    EXPECT_GT(x[k], x[k - 1]);
    EXPECT_NEAR(perimeter[k], perimeter[k - 1], 0.02 * perimeter[k]);
  }
  const Frame& last = both.frames.back();
  const auto nodes = std::count(last.kind.begin(), last.kind.end(), ParticleKind::membrane);
  EXPECT_EQ(nodes, both.header.nodes_per_cell[1]);
  EXPECT_TRUE(std::all_of(last.cell.begin(), last.cell.begin() + nodes, [](int cell) { return cell == 1; }));
}

TEST(Departure, AfterTheLastCellTheMembraneEffectsDoNotRun) {
  Case scene = vessel_that_a_cell_leaves();
  scene.numerics.spacing = 1e-6;
  Simulation simulation(scene);
  while (!simulation.state().cells[0].departure) {
    ASSERT_FALSE(simulation.finished());
    simulation.step();
  }
  const auto before = simulation.costs();
  for (int k = 0; k < 5; ++k) simulation.step();
  const auto after = simulation.costs();
  int slept = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const bool of_membranes = !before[k].kind->need(coarse_vessel()).called_for;
    EXPECT_EQ(after[k].usage.awake == before[k].usage.awake, of_membranes) << before[k].kind->name;
    slept += of_membranes;
  }
  EXPECT_GE(slept, 9);
}

}  // namespace
}  // namespace rouleau
