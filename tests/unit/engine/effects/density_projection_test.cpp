#include "engine/effects/density_projection.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "engine/effects/density_source_relaxation.h"
#include "engine/effects/gradient_from_least_pressure.h"
#include "engine/effects/number_density.h"
#include "engine/effects/particle_motion.h"
#include "engine/effects/pressure_coarse_space.h"
#include "engine/effects/pressure_density.h"
#include "engine/effects/velocity_correction.h"
#include "engine/effects/wall_end_exclusion.h"
#include "tests/unit/engine/effects/published_state.h"

namespace rouleau::effects {
namespace {

using particles::Group;

void stir(State& state, double speed, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> velocity(-speed, speed);
  for (int i = 0; i < state.particles.active_end(); ++i) {
    state.particles.u[i] = velocity(random);
    state.particles.v[i] = velocity(random);
  }
}

TEST(NumberDensity, CountsAtThePredictedPositions) {
  State state = published_state();
  stir(state, 3, 1);
  const auto before = state.particles;
  run(state, {&number_density});
  EXPECT_EQ(state.particles.x, before.x);
  EXPECT_EQ(state.particles.y, before.y);
  const auto& mps = state.projection.mps;
  const auto x = [&](int i) { return before.x[i] + (i < before.inlet_end() ? state.dt * before.u[i] : 0); };
  const auto y = [&](int i) { return before.y[i] + (i < before.inlet_end() ? state.dt * before.v[i] : 0); };
  ASSERT_EQ(static_cast<int>(state.projection.density.size()), before.velocity_end());
  for (int i = 0; i < before.velocity_end(); ++i) {
    double density = 0;
    for (int j = 0; j < before.size(); ++j) {
      if (j != i) density += mps.weight(std::hypot(x(j) - x(i), y(j) - y(i)));
    }
    EXPECT_NEAR(state.projection.density[i], density, 1e-5 * density);
    const double source = (density / mps.density() - 1) / (state.dt * state.dt);
    EXPECT_NEAR(state.projection.source[i], source, 1e-4 / (state.dt * state.dt));
  }
}

TEST(NumberDensity, FlowThatConvergesIsASource) {
  State state = published_state();
  for (int i = 0; i < state.particles.size(); ++i) state.particles.u[i] = 0.75 - state.particles.x[i];
  run(state, {&number_density});
  for (int i = 0; i < state.particles.active_end(); ++i) {
    if (!deep_inside(state, i)) continue;
    EXPECT_GT(state.projection.source[i], 0);
  }
}

TEST(DensitySourceRelaxation, LeavesAFifth) {
  State state = published_state();
  stir(state, 3, 2);
  run(state, {&number_density});
  const auto before = state.projection.source;
  run(state, {&density_source_relaxation});
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_DOUBLE_EQ(state.projection.source[i], 0.2 * before[i]);
  }
}

// The last columns lack more than a tenth of their neighbours, those before them a hundredth.
TEST(WallEndExclusion, LeavesOutWhatIsCutOffBeyondTheEndsAndNoFluid) {
  State state = published_state();
  run(state, {&number_density, &wall_end_exclusion});
  const auto& particles = state.particles;
  const auto& projection = state.projection;
  for (int i = 0; i < particles.velocity_end(); ++i) {
    const double column = particles.x[i] / state.spacing;
    const bool cut_off =
        (i >= particles.pressure_end() && column < -3) || (i >= particles.inlet_end() && column > 18);
    EXPECT_EQ(projection.has_pressure[i] == 0, cut_off) << i << " at " << column;
  }
  const auto& list = projection.neighbours;
  for (int i = 0; i < list.rows(); ++i) {
    for (int k = list.begin(i); k < list.end(i); ++k) {
      if (!projection.has_pressure[list.j[k]]) {
        EXPECT_EQ(projection.weights.pair[k], 0);
      } else if (list.r[k] < 0.2) {
        EXPECT_GT(projection.weights.pair[k], 0);
      }
    }
  }
}

/// Sum of a_ij (p_j - p_i) by the definition of eq. 9, over all that have pressure.
double laplacian_of_pressure(const State& state, int i) {
  const auto& projection = state.projection;
  const auto& list = projection.neighbours;
  double sum = 0;
  for (int k = list.begin(i); k < list.end(i); ++k) {
    const int j = list.j[k];
    if (!projection.has_pressure[j]) continue;
    sum += projection.mps.weight(list.r[k]) * (state.particles.p[j] - state.particles.p[i]);
  }
  return projection.mps.laplacian_scale() * sum;
}

State solved_state(std::initializer_list<const EffectKind*> between, bool with_outlet = true) {
  State state = published_state(with_outlet);
  stir(state, 1, 3);
  for (int i = state.particles.active_end(); i < state.particles.pressure_end(); ++i)
    state.particles.p[i] = 5;
  run(state, {&number_density, &density_source_relaxation, &wall_end_exclusion});
  run(state, between);
  run(state, {&pressure_density});
  return state;
}

TEST(PressureDensity, SolvesThePoissonEquationWithTheOutletsPressureGiven) {
  const State state = solved_state({});
  double worst = 0, size = 0;
  for (int i = 0; i < state.particles.velocity_end(); ++i) {
    if (i >= state.particles.active_end() && i < state.particles.pressure_end()) {
      EXPECT_EQ(state.particles.p[i], 5);
    } else if (state.projection.has_pressure[i]) {
      worst = std::max(worst, std::abs(laplacian_of_pressure(state, i) + state.projection.source[i]));
      size = std::max(size, std::abs(state.projection.source[i]));
    } else {
      EXPECT_EQ(state.particles.p[i], 0);
    }
  }
  EXPECT_GT(size, 0);
  EXPECT_LT(worst, 1e-4 * size);
  EXPECT_GT(state.counters.pressure_iterations, 10);
}

TEST(PressureDensity, WithoutAnOutletSourcesAreBalanced) {
  const State state = solved_state({}, false);
  double mean = 0, size = 0, worst = 0;
  int count = 0;
  for (int i = 0; i < state.particles.velocity_end(); ++i) {
    if (!state.projection.has_pressure[i]) continue;
    mean += state.projection.source[i];
    size = std::max(size, std::abs(state.projection.source[i]));
    ++count;
  }
  mean /= count;
  for (int i = 0; i < state.particles.velocity_end(); ++i) {
    if (!state.projection.has_pressure[i]) continue;
    worst = std::max(worst, std::abs(laplacian_of_pressure(state, i) + state.projection.source[i] - mean));
  }
  EXPECT_LT(worst, 1e-4 * size);
}

TEST(PressureCoarseSpace, GivesTheSamePressureInFewerIterations) {
  const State plain = solved_state({}), coarse = solved_state({&pressure_coarse_space});
  EXPECT_LT(5 * coarse.counters.pressure_iterations, 4 * plain.counters.pressure_iterations);
  double largest = 0;
  for (const double p : plain.particles.p) largest = std::max(largest, std::abs(p));
  for (int i = 0; i < plain.particles.velocity_end(); ++i) {
    EXPECT_NEAR(coarse.particles.p[i], plain.particles.p[i], 1e-4 * largest);
  }
}

TEST(GradientFromLeastPressure, TakesTheLeastWithinReach) {
  State state = solved_state({});
  EXPECT_EQ(state.projection.base,
            std::vector<double>(state.particles.p.begin(),
                                state.particles.p.begin() + state.particles.active_end()));
  run(state, {&gradient_from_least_pressure});
  const auto& particles = state.particles;
  const auto& list = state.projection.neighbours;
  for (int i = 0; i < particles.active_end(); ++i) {
    double least = particles.p[i];
    for (int k = list.begin(i); k < list.end(i); ++k) {
      if (state.projection.has_pressure[list.j[k]]) least = std::min(least, particles.p[list.j[k]]);
    }
    EXPECT_EQ(state.projection.base[i], least);
  }
}

TEST(VelocityCorrection, TakesAwayTheGradientTimesTheStep) {
  State state = published_state();
  run(state, {&number_density});
  for (int i = 0; i < state.particles.size(); ++i) {
    state.particles.p[i] = 2 * state.particles.x[i] - 3 * state.particles.y[i];
  }
  state.projection.base.assign(state.particles.p.begin(),
                               state.particles.p.begin() + state.particles.active_end());
  run(state, {&velocity_correction});
  for (int i = 0; i < state.particles.active_end(); ++i) {
    if (!deep_inside(state, i)) continue;
    EXPECT_NEAR(state.particles.u[i], -2 * state.dt, 1e-4 * state.dt);
    EXPECT_NEAR(state.particles.v[i], 3 * state.dt, 1e-4 * state.dt);
  }
}

TEST(ParticleMotion, PutsParticlesWhereTheFlowCarriedThem) {
  State state = published_state();
  state.next_x = state.particles.x;
  state.next_y = state.particles.y;
  state.next_x[7] += 0.01;
  state.next_y[7] -= 0.02;
  run(state, {&particle_motion});
  EXPECT_EQ(state.particles.x, state.next_x);
  EXPECT_EQ(state.particles.y, state.next_y);
}

}  // namespace
}  // namespace rouleau::effects
