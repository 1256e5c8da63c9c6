#include "engine/observe/series.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

using Names = std::vector<std::string>;

Names column_names(int cells) {
  Names names;
  for (const Column& column : series_columns(coarse_vessel_with_cells(cells))) names.push_back(column.name);
  return names;
}

const Names flow = {"inflow", "outflow", "pressure_drop", "particles", "time_step", "divergence"};

Names of_cell(const std::string& cell) {
  return {cell + ".x",        cell + ".y",    cell + ".u",         cell + ".v",    cell + ".tau",
          cell + ".tau_area", cell + ".area", cell + ".perimeter", cell + ".angle"};
}

Names of_membrane(const std::string& cell) {
  return {cell + ".strain_mean",
          cell + ".strain_greatest",
          cell + ".tank_treading_phase",
          cell + ".tank_treading_frequency",
          cell + ".shape",
          cell + ".thickness",
          cell + ".wall_gap"};
}

Names joined(std::initializer_list<Names> parts) {
  Names all;
  for (const Names& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(Series, ColumnsAreTheOnesPromised) {
  EXPECT_EQ(column_names(0), joined({{"time"}, flow, {"poiseuille_deviation"}}));
  EXPECT_EQ(column_names(1), joined({{"time"}, of_cell("cell0"), flow, of_membrane("cell0"), {"spacing"}}));
  EXPECT_EQ(column_names(2), joined({{"time"},
                                     of_cell("cell0"),
                                     of_cell("cell1"),
                                     flow,
                                     of_membrane("cell0"),
                                     {"cell0.cell_gap"},
                                     of_membrane("cell1"),
                                     {"cell1.cell_gap"},
                                     {"spacing"}}));
}

TEST(Series, ABifurcationHasTwoOutflows) {
  Case scene = coarse_vessel();
  scene.vessel.shape = Shape::bifurcation;
  Names names;
  for (const Column& column : series_columns(scene)) names.push_back(column.name);
  EXPECT_EQ(names, (Names{"time", "inflow", "outflow0", "outflow1", "pressure_drop", "particles", "time_step",
                          "divergence"}));
}

TEST(Series, DeviationFromTheParabolaIsThereWhereTheFlowBecomesOne) {
  const auto has_it = [](const Case& scene) {
    return series_columns(scene).back().name == "poiseuille_deviation";
  };
  EXPECT_TRUE(has_it(coarse_vessel()));
  EXPECT_FALSE(has_it(coarse_vessel_with_cells(1)));
  Case scene = coarse_vessel();
  scene.vessel.ends = Ends::periodic;
  EXPECT_FALSE(has_it(scene));
  scene = coarse_vessel();
  scene.thrombi = {{Wall::lower, 7e-6, 2e-6}};
  EXPECT_FALSE(has_it(scene));
  scene = coarse_vessel();
  scene.inflow.waveform = {{0, 1}, {1e-4, -1}};
  EXPECT_FALSE(has_it(scene));
  scene = coarse_vessel();
  scene.body_acceleration = {1, 0};
  EXPECT_FALSE(has_it(scene));
  scene = coarse_vessel();
  scene.vessel.wall_velocity.upper = 1e-3;
  EXPECT_FALSE(has_it(scene));
}

TEST(Series, EveryColumnHasAUnit) {
  const std::set<std::string> units = {"1", "s", "m", "m/s", "m2", "m2/s", "Pa", "deg", "1/s"};
  for (const Column& column : series_columns(coarse_vessel_with_cells(1))) {
    EXPECT_TRUE(units.contains(column.unit)) << column.name << " in " << column.unit;
  }
}

class SeriesRows : public testing::TestWithParam<int> {};

TEST_P(SeriesRows, HaveAFiniteValueAColumn) {
  Case scene = coarse_vessel_with_cells(GetParam());
  if (GetParam() == 0) scene.vessel.length = 15e-6;
  scene.duration = 1e-4;
  Recorder recorder;
  run_case(scene, recorder);
  ASSERT_GE(recorder.rows.size(), 3u);
  for (const auto& row : recorder.rows) {
    ASSERT_EQ(row.size(), recorder.header.columns.size());
    for (const double value : row) ASSERT_TRUE(std::isfinite(value));
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, SeriesRows, testing::Values(0, 1, 2));

TEST(Series, TheFirstRowIsTheSceneAsGiven) {
  const Case scene = coarse_vessel_with_cells(1);
  Recorder recorder;
  run_case(scene, recorder);
  const auto value = [&](const std::string& name) {
    for (std::size_t c = 0; c < recorder.header.columns.size(); ++c) {
      if (recorder.header.columns[c].name == name) return recorder.rows[0][c];
    }
    ADD_FAILURE() << "no column " << name;
    return 0.0;
  };
  const RedCell& cell = scene.cells[0];
  EXPECT_EQ(value("time"), 0);
  EXPECT_NEAR(value("cell0.x"), cell.x, 1e-12);
  EXPECT_NEAR(value("cell0.y"), cell.y, 1e-12);
  EXPECT_NEAR(value("cell0.area"), cell.fill * std::numbers::pi * cell.diameter * cell.diameter / 4,
              1e-9 * 3e-11);
  EXPECT_NEAR(std::abs(value("cell0.angle")), 90, 1e-6);
  EXPECT_NEAR(value("cell0.tau"), 1, 1e-12);
  EXPECT_NEAR(value("cell0.tau_area"), 1, 1e-12);
  EXPECT_NEAR(value("cell0.thickness"), 2 * value("cell0.area") / value("cell0.perimeter"), 1e-15);
  EXPECT_NEAR(value("cell0.tank_treading_phase"), 0, 1e-9);
  EXPECT_GT(value("cell0.wall_gap"), 0);
  EXPECT_LT(value("cell0.wall_gap"), cell.y - cell.diameter / 2);
  EXPECT_NEAR(value("inflow"), scene.inflow.velocity * scene.vessel.diameter, 0.01 * 5e-8);
}

}  // namespace
}  // namespace rouleau::observe
