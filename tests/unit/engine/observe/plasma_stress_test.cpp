#include "engine/observe/plasma_stress.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/cells/ring.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/observe/cells_of_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

effects::State resting_cell() {
  Case scene = coarse_vessel_with_cells();
  scene.numerics.spacing = 0.5e-6;
  return effects::prepared_state(scene);
}

TEST(PlasmaStress, OfSimpleShearIsViscosityTimesShearRate) {
  effects::State state = resting_cell();
  set_velocity(state, [](double, double y) { return std::array{3 * y, 0.0}; });
  EXPECT_NEAR(scalar_shear_stress(state, state.cells[0]), 3 * state.viscosity, 1e-6 * state.viscosity);
}

TEST(PlasmaStress, OfPlaneExtensionIsTwiceViscosityTimesTheRate) {
  effects::State state = resting_cell();
  set_velocity(state, [](double x, double y) { return std::array{2 * x, -2 * y}; });
  EXPECT_NEAR(scalar_shear_stress(state, state.cells[0]), 4 * state.viscosity, 1e-5 * state.viscosity);
}

TEST(PlasmaStress, OfRotationIsNone) {
  effects::State state = resting_cell();
  set_velocity(state, [](double x, double y) { return std::array{-y, x}; });
  EXPECT_LT(scalar_shear_stress(state, state.cells[0]), 1e-5 * state.viscosity);
}

TEST(PlasmaStress, OfPoiseuilleFlowIsTheMeanAlongTheMembrane) {
  effects::State state = resting_cell();
  set_velocity(state, [](double, double y) { return std::array{effects::State::parabola(y), 0.0}; });
  const cells::Ring ring = state.ring(state.cells[0]);
  double sum = 0, length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t before = ring.previous(i), after = ring.next(i);
    const double chord = std::hypot(ring.x[after] - ring.x[before], ring.y[after] - ring.y[before]);
    sum += chord * std::abs(6 - 12 * ring.y[i]);
    length += chord;
  }
  // Where the fit is linear (among few particles) the parabola's curvature is left out.
  EXPECT_NEAR(scalar_shear_stress(state, state.cells[0]) / state.viscosity, sum / length,
              0.02 * sum / length);
}

TEST(PlasmaStress, DoesNotDependOnTheFlowInsideTheCell) {
  effects::State state = resting_cell();
  set_velocity(state, [](double, double y) { return std::array{3 * y, 0.0}; });
  auto& particles = state.particles;
  int inside = 0;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    if (particles.cell[i] < 0) continue;
    particles.u[i] = 50;
    ++inside;
  }
  ASSERT_GT(inside, 20);
  EXPECT_NEAR(scalar_shear_stress(state, state.cells[0]), 3 * state.viscosity, 1e-6 * state.viscosity);
}

}  // namespace
}  // namespace rouleau::observe
