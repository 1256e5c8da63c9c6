#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "engine/observe/observer.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/same_particles.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

constexpr const char* outputs[] = {"hydraulic_resistance", "cell_free_layer", "fahraeus", "membrane_maps",
                                   "hemolysis"};

Case with_all(Case scene) {
  for (const char* output : outputs) scene.effects[output] = {Switch::on};
  return scene;
}

/// Two cells of which the first one downstream leaves.
Case vessel_that_a_cell_leaves() {
  Case scene = coarse_vessel_with_cells(2);
  scene.vessel.length = 26e-6;
  scene.duration = 1.2e-3;
  return scene;
}

TEST(OptionalOutputs, AreNotThereUnlessAskedFor) {
  Recorder recorder;
  const RunSummary summary = run_case(coarse_vessel_with_cells(), recorder);
  EXPECT_TRUE(summary.findings.empty() && recorder.header.membrane_fields.empty());
  for (const Frame& frame : recorder.frames) EXPECT_TRUE(frame.membrane_fields.empty());
  for (const EffectTime& time : summary.effect_times) {
    for (const char* output : outputs) EXPECT_NE(time.name, output);
  }
  for (const PlannedEffect& effect : recorder.header.plan.effects) {
    for (const char* output : outputs) {
      if (effect.name != output) continue;
      EXPECT_FALSE(effect.on);
      EXPECT_NE(effect.reason.find("does not ask"), std::string::npos);
    }
  }
}

TEST(OptionalOutputs, ChangeNothingElse) {
  Recorder without, with;
  run_case(vessel_that_a_cell_leaves(), without);
  run_case(with_all(vessel_that_a_cell_leaves()), with);
  ASSERT_EQ(with.rows.size(), without.rows.size());
  const std::size_t columns = without.header.columns.size();
  ASSERT_GT(with.header.columns.size(), columns);
  for (std::size_t c = 0; c < columns; ++c) {
    EXPECT_EQ(with.header.columns[c].name, without.header.columns[c].name);
    for (std::size_t k = 0; k < with.rows.size(); ++k) {
      const double one = with.rows[k][c], other = without.rows[k][c];
      EXPECT_TRUE(one == other || (std::isnan(one) && std::isnan(other))) << with.header.columns[c].name;
    }
  }
  ASSERT_EQ(with.frames.size(), without.frames.size());
  for (std::size_t k = 0; k < with.frames.size(); ++k)
    expect_same_particles(with.frames[k], without.frames[k]);
}

TEST(OptionalOutputs, ColumnsOfACellEndWhereItLeaves) {
  Recorder recorder;
  const RunSummary summary = run_case(with_all(vessel_that_a_cell_leaves()), recorder);
  ASSERT_TRUE(summary.cells[1].departure);
  const std::set<std::string> of_cell{"cell1.resistance", "cell1.strain_share", "cell1.tension_share",
                                      "cell1.scalar_shear_stress", "cell1.hemolysis"};
  std::size_t seen = 0;
  for (std::size_t c = 0; c < recorder.header.columns.size(); ++c) {
    const std::string& name = recorder.header.columns[c].name;
    if (of_cell.contains(name)) {
      ++seen;
      EXPECT_FALSE(std::isnan(recorder.rows[2][c])) << name;
      EXPECT_TRUE(std::isnan(recorder.rows.back()[c])) << name;
    }
  }
  EXPECT_EQ(seen, of_cell.size());
  // Frames carry the fields of the nodes that are left.
  const auto nodes = static_cast<std::size_t>(recorder.header.nodes_per_cell[0]);
  EXPECT_EQ(recorder.frames.back().membrane_fields[0].size(), nodes);
}

TEST(OptionalOutputs, AreRefusedWhereTheyMakeNoSense) {
  Case box = coarse_vessel();
  box.vessel.shape = Shape::box;
  box.vessel.ends = Ends::closed;
  for (const ObserverKind* kind : catalogue()) {
    for (const char* output : outputs) {
      if (kind->name != output) continue;
      const effects::Need need = kind->need(box);
      EXPECT_FALSE(need.called_for || need.on_request) << output;
      EXPECT_FALSE(need.reason.empty() || need.pointer.empty()) << output;
    }
  }
}

}  // namespace
}  // namespace rouleau::observe
