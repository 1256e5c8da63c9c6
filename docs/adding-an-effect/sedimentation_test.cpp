#include "engine/effects/sedimentation.h"

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "engine/plan/plan.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

Case sinking(double density_difference) {
  Case scene = coarse_vessel_with_cells();
  scene.effects["sedimentation"] = {Switch::on, {{"density_difference", density_difference}}};
  return scene;
}

TEST(Sedimentation, PullsWithTheCellsWeightInPlasma) {
  State state = prepared_state(sinking(80));
  sedimentation.make(state)->apply(state);
  double force = 0;
  for (const double a : state.ay) force += a * state.spacing * state.spacing * state.scales.acceleration();
  const double area = cells::area(state.ring(state.cells[0]));
  EXPECT_NEAR(force / (-0.08 * 9.81 * area), 1, 1e-12);
}

TEST(Sedimentation, RunsOnlyWhereItIsAskedFor) {
  EXPECT_FALSE(runs(make_plan(coarse_vessel_with_cells()), "sedimentation"));
  EXPECT_TRUE(runs(make_plan(sinking(80)), "sedimentation"));
  Case empty = sinking(80);
  empty.cells.clear();
  EXPECT_THROW(make_plan(empty), CaseError);
}

TEST(Sedimentation, ACellSinksInPlasmaAtRest) {
  Case scene = sinking(80);
  scene.vessel.ends = Ends::periodic;
  Simulation simulation(scene);
  const auto centre = [&] { return cells::measure(simulation.state().ring(simulation.state().cells[0])).y; };
  const double before = centre();
  for (int k = 0; k < 10; ++k) simulation.step();
  EXPECT_LT(centre(), before);
}

}  // namespace
}  // namespace rouleau::effects
