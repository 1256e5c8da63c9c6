#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "engine/case/case_keys.h"
#include "engine/case/presets.h"
#include "engine/effects/effect.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

TEST(Catalogue, NamesAreUniqueAndCanBeWrittenInACase) {
  std::set<std::string_view> names;
  for (const EffectKind* kind : catalogue()) {
    EXPECT_TRUE(names.insert(kind->name).second) << kind->name;
    EXPECT_TRUE(is_lower_snake_case(kind->name)) << kind->name;
  }
  EXPECT_GT(names.size(), 10u);
}

TEST(Catalogue, RunsStageByStage) {
  const auto& kinds = catalogue();
  EXPECT_TRUE(std::is_sorted(kinds.begin(), kinds.end(),
                             [](const EffectKind* a, const EffectKind* b) { return a->stage < b->stage; }));
}

TEST(Catalogue, EveryAnswerHasAReasonAndPointsIntoTheCase) {
  for (const Case& scene : {coarse_vessel(), coarse_vessel_with_cells()}) {
    for (const EffectKind* kind : catalogue()) {
      const Need need = kind->need(scene);
      EXPECT_FALSE(need.reason.empty()) << kind->name;
      EXPECT_TRUE(need.pointer.empty() || need.pointer[0] == '/') << kind->name;
    }
  }
}

TEST(Catalogue, MembranesEffectsAreCalledForByCellsAlone) {
  std::set<std::string> of_membranes;
  for (const EffectKind* kind : catalogue()) {
    const bool without = kind->need(coarse_vessel()).called_for;
    const bool with = kind->need(coarse_vessel_with_cells()).called_for;
    if (with && !without) of_membranes.insert(std::string(kind->name));
  }
  EXPECT_EQ(of_membranes, (std::set<std::string>{"stretch", "bending", "contact", "membrane_coupling",
                                                 "area_control", "membrane_clearance", "membrane_sides",
                                                 "membrane_watch", "departure", "fading", "thin_cells"}));
}

TEST(Catalogue, EveryEffectIsForSomeScene) {
  Case published = coarse_vessel();
  published.numerics = preset_numerics(Preset::paper);
  published.cells = coarse_vessel_with_cells().cells;
  Case deflating = coarse_vessel_with_cells();
  deflating.cells[0].shape = CellShape::circle;
  Case driven = coarse_vessel();
  driven.vessel.ends = Ends::periodic;
  driven.body_acceleration = {1, 0};
  Case viscous = coarse_vessel_with_cells();
  viscous.cells[0].viscosity_ratio = 5;
  Case held = coarse_vessel_with_cells();
  held.effects["inextensible"] = Switch::on;
  Case pair = coarse_vessel_with_cells(2);
  pair.numerics.spacing = 0.5e-6;
  Case lid = coarse_vessel();
  lid.vessel.shape = Shape::box;
  lid.vessel.ends = Ends::closed;
  lid.vessel.wall_velocity.upper = 1;
  Case pulsing = coarse_vessel();
  pulsing.inflow.waveform = {{0, 1}, {1e-3, 2}};
  for (const EffectKind* kind : catalogue()) {
    bool used = false;
    for (const Case& scene :
         {coarse_vessel_with_cells(), published, deflating, driven, viscous, held, pair, lid, pulsing}) {
      const Need need = kind->need(scene);
      used = used || need.called_for || need.on_request;
    }
    EXPECT_TRUE(used) << kind->name;
  }
}

TEST(Catalogue, EveryEffectCanBeMade) {
  State state = prepared_state(coarse_vessel_with_cells());
  for (const EffectKind* kind : catalogue()) EXPECT_NE(kind->make(state), nullptr) << kind->name;
}

TEST(Catalogue, StagesHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Stage stage : {Stage::boundaries, Stage::operators, Stage::forces, Stage::viscosity,
                            Stage::pressure, Stage::motion, Stage::checks}) {
    EXPECT_TRUE(names.insert(name_of(stage)).second);
  }
}

}  // namespace
}  // namespace rouleau::effects
