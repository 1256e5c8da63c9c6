#include "engine/observe/hydraulic_resistance.h"

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

using effects::State;

Case parabolic(Case scene) {
  scene.inflow.profile = Profile::parabolic;
  return scene;
}

std::unique_ptr<const State> not_asked_for() {
  ADD_FAILURE() << "the flow is known";
  return nullptr;
}

TEST(UnitFlow, BetweenParallelWallsIsPoiseuilles) {
  const State state = effects::prepared_state(parabolic(coarse_vessel_with_cells()));
  const auto unit = unit_flow(state, not_asked_for);
  EXPECT_DOUBLE_EQ(unit->drive(), 12 * state.viscosity * 2);
  EXPECT_DOUBLE_EQ(unit->velocity(0.3, 0.25)[0], 6 * 0.25 * 0.75);
  const auto [xx, xy, yy] = unit->stress(0.5, 0.25);
  EXPECT_DOUBLE_EQ(xx, -12 * state.viscosity * 1.5);
  EXPECT_DOUBLE_EQ(xy, 12 * state.viscosity * 0.25);
  EXPECT_DOUBLE_EQ(yy, xx);
}

TEST(UnitFlow, OfSettledParticlesIsThatOfTheirFlow) {
  const Case scene = coarse_vessel();  // fed with a plug
  const State start = effects::prepared_state(scene);
  const auto settled = [&] {
    auto state = std::make_unique<State>(effects::prepared_state(scene));
    set_velocity(*state, [](double, double y) { return std::array{2 * State::parabola(y), 0.0}; });
    for (int i = 0; i < state->particles.pressure_end(); ++i) {
      state->particles.p[i] = 24 * state->viscosity * (1.5 - state->particles.x[i]);
    }
    return std::unique_ptr<const State>(std::move(state));
  };
  const auto unit = unit_flow(start, settled);
  EXPECT_NEAR(unit->drive(), 18 * start.viscosity, 1e-6 * start.viscosity);
  EXPECT_NEAR(unit->velocity(0.7, 0.2)[0], State::parabola(0.2), 1e-6);
  const auto [xx, xy, yy] = unit->stress(0.7, 0.2);
  EXPECT_NEAR(xx / start.viscosity, -12 * 0.8, 1e-4);
  EXPECT_NEAR(xy / start.viscosity, 12 * 0.3, 1e-4);
  EXPECT_NEAR(yy / start.viscosity, -12 * 0.8, 1e-4);
}

TEST(HydraulicResistance, OfAMoreViscousDiscInUndisturbedFlowIsItsExtraDissipation) {
  Case scene = parabolic(coarse_vessel_with_cells());
  scene.numerics.spacing = 0.25e-6;
  scene.cells[0].viscosity_ratio = 3;
  State state = effects::prepared_state(scene);
  const double radius = 0.3, middle = 0.4;
  put_nodes(state, 0, [&](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return std::array{1 + radius * std::cos(angle), middle + radius * std::sin(angle)};
  });
  set_velocity(state, [](double, double y) { return std::array{State::parabola(y), 0.0}; });
  const double added = pressure_by_cells(state, *unit_flow(state, not_asked_for))[0];
  // (lambda - 1) times the integral of nu (du/dy)^2 over the disc.
  const double off = middle - 0.5;
  const double expected =
      2 * 144 * state.viscosity * std::numbers::pi * radius * radius * (off * off + radius * radius / 4);
  EXPECT_NEAR(added, expected, 0.005 * expected);
}

TEST(HydraulicResistance, OfForcesOnTheFluidIsTheirWorkOnTheUnitFlow) {
  State state = effects::prepared_state(parabolic(coarse_vessel_with_cells(2)));
  put_nodes(state, 1, [](double t) { return std::array{1.5, t}; });
  const std::size_t first = static_cast<std::size_t>(state.cells[1].first_node);
  const auto nodes = static_cast<std::size_t>(state.cells[1].nodes);
  // Along x a force everywhere, so in the mean over the height it meets the mean velocity; one across does
  // no work.
  for (std::size_t i = first; i < first + nodes; ++i) {
    state.load.fx[i] = -2.0 / static_cast<double>(nodes);
    state.load.fy[i] = 5;
  }
  const auto added = pressure_by_cells(state, *unit_flow(state, not_asked_for));
  EXPECT_EQ(added[0], 0);
  EXPECT_NEAR(added[1], 2, 0.01);
}

TEST(HydraulicResistance, OfPlasmaIsPoiseuilles) {
  Case scene = parabolic(coarse_vessel());
  scene.duration = 2e-3;  // the pressure is slow to follow the start
  scene.effects["hydraulic_resistance"] = {Switch::on};
  Recorder recorder;
  run_case(scene, recorder);
  const auto& columns = recorder.header.columns;
  std::size_t resistance = 0;
  while (columns.at(resistance).name != "resistance") ++resistance;
  const double expected = 12e-3 * 15e-6 / 1e-15;
  EXPECT_DOUBLE_EQ(recorder.rows.back()[resistance + 1], expected);
  EXPECT_NEAR(recorder.rows.back()[resistance], expected, 1e-3 * expected);
}

}  // namespace
}  // namespace rouleau::observe
