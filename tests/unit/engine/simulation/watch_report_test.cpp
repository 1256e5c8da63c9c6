#include "engine/simulation/watch_report.h"

#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Warnings of a run, at d0 = 1 um, whose cell was thinnest at 2 ms: 1.5 spacings.
std::vector<std::string> warnings(const std::vector<Refinement>& refinements) {
  effects::State state = effects::prepared_state(coarse_vessel_with_cells());
  state.counters.cells.resize(1);
  state.counters.cells[0].least_thickness = 1.5;
  state.counters.cells[0].thinnest_time = 2e-3 / state.scales.time();
  RunSummary summary;
  summary.refinements = refinements;
  report_watch(state, summary);
  return summary.warnings;
}

TEST(WatchReport, WarnsOfAThinCellWithTheSpacingOfThen) {
  EXPECT_THAT(warnings({}), ElementsAre(HasSubstr("a spacing of 0.75 um would")));
  EXPECT_THAT(warnings({{1e-3, 0, 0.5e-6}}), ElementsAre(HasSubstr("a spacing of 0.375 um would")));
  EXPECT_THAT(warnings({{3e-3, 0, 0.5e-6}}), ElementsAre(HasSubstr("a spacing of 0.75 um would")));
}

TEST(WatchReport, DoesNotWarnOfWhatAFinerSpacingMended) {
  EXPECT_THAT(warnings({{2e-3, 0, 0.5e-6}}), IsEmpty());
  EXPECT_THAT(warnings({{1e-3, 0, 0.5e-6}, {2e-3, 0, 0.4e-6}}), IsEmpty());
  // New nodes alone make nothing finer.
  EXPECT_THAT(warnings({{2e-3, 0, 1e-6}}), ElementsAre(HasSubstr("0.75 um")));
}

}  // namespace
}  // namespace rouleau
