#include "engine/effects/deflation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/cells/shape.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

Case vessel_with_circle() {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.length = 30e-6;
  scene.cells[0].shape = CellShape::circle;
  return scene;
}

int enclosed(const State& state) {
  int count = 0;
  for (int i = state.particles.membrane_end(); i < state.particles.active_end(); ++i) {
    count += state.particles.cell[i] == 0;
  }
  return count;
}

double circle_of(const State& state) {
  const double diameter = state.scene.cells[0].diameter / state.scales.length;
  return std::numbers::pi * diameter * diameter / 4;
}

TEST(Deflation, StartsFromTheCircleWithParticlesInside) {
  const State state = prepared_state(vessel_with_circle());
  const cells::Shape shape = cells::measure(state.ring(state.cells[0]));
  EXPECT_NEAR(shape.area, circle_of(state), 1e-9 * circle_of(state));
  const cells::Ring ring = state.ring(state.cells[0]);
  const double radius = std::hypot(ring.x[0] - shape.x, ring.y[0] - shape.y);
  for (std::size_t q = 0; q < ring.size(); ++q) {
    EXPECT_NEAR(std::hypot(ring.x[q] - shape.x, ring.y[q] - shape.y), radius, 1e-9);
  }
  EXPECT_EQ(enclosed(state), state.cells[0].circle_particles);
  EXPECT_GT(enclosed(state), 15);
}

TEST(Deflation, LetsTheAreaFallEvenlyAndTakesParticlesInProportion) {
  State state = prepared_state(vessel_with_circle());
  const int before = enclosed(state);
  const auto effect = deflation.make(state);
  const double time = state.scene.cells[0].diameter / state.scales.length, circle = circle_of(state);
  for (const double progress : {0.25, 0.5, 1.0, 2.0}) {
    state.time = progress * time - state.dt;
    effect->apply(state);
    state.neighbours.sort(state.particles);
    state.neighbours.build(state.particles);
    const double wanted = circle * (1 - 0.4 * std::min(progress, 1.0));
    EXPECT_NEAR(state.cells[0].start_area, wanted, 1e-9 * circle);
    const double square = state.spacing * state.spacing;
    EXPECT_NEAR(state.cells[0].area_rate * enclosed(state) * square, progress < 1 ? -0.4 * circle / time : 0,
                1e-9);
    const double lost = (circle - wanted) / square;
    EXPECT_EQ(enclosed(state), before - static_cast<int>(std::lround(lost)));
  }
}

TEST(Deflation, TakesTheMostCrowdedFirst) {
  State state = prepared_state(vessel_with_circle());
  auto& particles = state.particles;
  int neighbour = particles.membrane_end();
  while (particles.cell[neighbour] != 0) ++neighbour;
  const double x = particles.x[neighbour] + 0.1 * state.spacing;
  const int added = particles.add(particles::Group::fluid, x, particles.y[neighbour], 0);
  const auto first_id = particles.id[neighbour], second_id = particles.id[added];
  state.neighbours.sort(particles);
  state.neighbours.build(particles);
  const int before = enclosed(state);
  state.cells[0].circle_particles = before - 1;
  state.time = -state.dt;
  deflation.make(state)->apply(state);
  state.neighbours.sort(particles);
  ASSERT_EQ(enclosed(state), before - 1);
  int left = 0;
  for (const auto id : particles.id) left += id == first_id || id == second_id;
  EXPECT_EQ(left, 1);
}

TEST(Deflation, KeepsThePlasmaOutAndTheAreaAsWanted) {
  Simulation simulation(vessel_with_circle());
  const State& state = simulation.state();
  double worst = 0;
  while (!simulation.finished()) {
    simulation.step();
    const double area = cells::area(state.ring(state.cells[0]));
    worst = std::max(worst, std::abs(area / state.cells[0].start_area - 1));
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_LT(state.cells[0].start_area, 0.9 * circle_of(state));
  const cells::Ring ring = state.ring(state.cells[0]);
  for (int i = state.particles.membrane_end(); i < state.particles.active_end(); ++i) {
    EXPECT_EQ(cells::contains(ring, state.particles.x[i], state.particles.y[i]),
              state.particles.cell[i] == 0);
  }
}

}  // namespace
}  // namespace rouleau::effects
