#include "engine/observe/membrane_maps.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/observe/cells_of_state.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

/// A cell as a circle whose links are stretched by so much.
effects::State circle_with_strain(double strain) {
  effects::State state = effects::prepared_state(coarse_vessel_with_cells());
  const effects::CellState& cell = state.cells[0];
  const double link = cell.material.rest_length * (1 + strain);
  const double radius = link / (2 * std::sin(std::numbers::pi / cell.nodes));
  put_nodes(state, 0, [&](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return std::array{0.8 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)};
  });
  return state;
}

TEST(MembraneMaps, OfAnEvenlyStretchedCircleAreTheSpringsOwn) {
  const effects::State state = circle_with_strain(0.2);
  const LinkMaps maps = link_maps(state, state.cells[0]);
  ASSERT_EQ(maps.strain.size(), static_cast<std::size_t>(state.cells[0].nodes));
  for (const double strain : maps.strain) EXPECT_NEAR(strain, 0.2, 1e-12);
  // N = E_s times the strain.
  for (const double tension : maps.tension) EXPECT_NEAR(tension * state.scales.tension(), 2e-6, 1e-16);
}

TEST(MembraneMaps, ACrushedLinkPushesBackElevenfold) {
  const effects::State state = circle_with_strain(-0.3);
  const double tension = link_maps(state, state.cells[0]).tension[3] * state.scales.tension();
  EXPECT_NEAR(tension, 1e-5 * (-0.3 - 10 * 0.1), 1e-16);
}

TEST(MembraneMaps, OfAMembraneWithNodesPlacedAnewAreThoseOfItsFirstLinks) {
  effects::State state = circle_with_strain(0.2);
  const LinkMaps before = link_maps(state, state.cells[0]);
  // Every other node is taken out, each piece of membrane keeping its unstretched length.
  effects::CellState& cell = state.cells[0];
  auto& particles = state.particles;
  ASSERT_EQ(cell.nodes % 2, 0);
  for (int q = 0; q < cell.nodes / 2; ++q) {
    particles.x[q] = particles.x[2 * q];
    particles.y[q] = particles.y[2 * q];
  }
  cell.nodes /= 2;
  cell.material.rest_lengths.assign(static_cast<std::size_t>(cell.nodes), 2 * cell.material.rest_length);
  const LinkMaps after = link_maps(state, cell);
  ASSERT_EQ(after.strain.size(), before.strain.size());
  // Cubics through ten nodes follow a circle within that.
  for (const double strain : after.strain) EXPECT_NEAR(strain, 0.2, 0.003);
}

TEST(MembraneMaps, OfAMembraneThatIsHeldHaveTheTensionThatHoldsIt) {
  effects::State state = circle_with_strain(0);
  effects::CellState& cell = state.cells[0];
  for (int q = 0; q < cell.nodes; ++q) cell.held.tension.push_back(0.1 * q);
  EXPECT_EQ(link_maps(state, cell).tension, cell.held.tension);
}

TEST(MembraneMaps, SharesCountWhatIsAboveTheThreshold) {
  EXPECT_EQ(share_above({0.1, 0.2, 0.3, 0.4}, 0.25), 0.5);
  EXPECT_EQ(share_above({0.1, 0.2}, 0.2), 0);
}

Case with_maps(double threshold) {
  Case scene = coarse_vessel_with_cells();
  scene.effects["membrane_maps"] = {Switch::on, {{"strain_threshold", threshold}}};
  return scene;
}

TEST(MembraneMaps, AreInFramesSeriesAndSummary) {
  Recorder recorder;
  const RunSummary summary = run_case(with_maps(0.02), recorder);
  ASSERT_EQ(recorder.header.membrane_fields.size(), 2u);
  EXPECT_EQ(recorder.header.membrane_fields[1].unit, "N/m");
  const auto nodes = static_cast<std::size_t>(recorder.header.nodes_per_cell[0]);
  const auto& columns = recorder.header.columns;
  const auto column = std::find_if(columns.begin(), columns.end(),
                                   [](const Column& c) { return c.name == "cell0.strain_share"; });
  ASSERT_NE(column, columns.end());
  // Frames come at every second or third row.
  const auto row_at = [&](double time) {
    for (const auto& row : recorder.rows) {
      if (std::abs(row[0] - time) < 1e-9) return row;
    }
    return std::vector<double>{};
  };
  int compared = 0;
  double greatest = 0;
  for (const Frame& frame : recorder.frames) {
    ASSERT_EQ(frame.membrane_fields.size(), 2u);
    const auto& strain = frame.membrane_fields[0];
    ASSERT_EQ(strain.size(), nodes);
    EXPECT_EQ(frame.membrane_fields[1].size(), nodes);
    const double share = share_above(std::vector<double>(strain.begin(), strain.end()), 0.02);
    greatest = std::max(greatest, share);
    if (const auto row = row_at(frame.time); !row.empty()) {
      EXPECT_NEAR(row[static_cast<std::size_t>(column - columns.begin())], share, 1e-12);
      ++compared;
    }
  }
  EXPECT_GE(compared, 2);
  EXPECT_GT(greatest, 0);
  const auto found = std::find_if(summary.findings.begin(), summary.findings.end(),
                                  [](const Finding& f) { return f.name == "cell0.strain_share_greatest"; });
  ASSERT_NE(found, summary.findings.end());
  EXPECT_GE(found->value, greatest);
}

}  // namespace
}  // namespace rouleau::observe
