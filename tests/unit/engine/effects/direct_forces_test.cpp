#include "engine/effects/direct_forces.h"

#include <gtest/gtest.h>

#include "engine/case/presets.h"
#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

TEST(DirectForces, AccelerateTheNodesByTheMassOfAParticleAndNothingElse) {
  Case scene = coarse_vessel_with_cells();
  scene.numerics = preset_numerics(Preset::paper);
  scene.numerics.spacing = 1e-6;
  State state = prepared_state(scene);
  const int nodes = state.particles.membrane_end();
  for (int q = 0; q < nodes; ++q) {
    state.load.fx[q] = 1 + q;
    state.load.fy[q] = -2 * q;
  }
  const auto effect = direct_forces.make(state);
  effect->apply(state);
  const double mass = state.spacing * state.spacing;
  for (int i = 0; i < state.particles.active_end(); ++i) {
    EXPECT_DOUBLE_EQ(state.ax[i], i < nodes ? (1 + i) / mass : 0);
    EXPECT_DOUBLE_EQ(state.ay[i], i < nodes ? -2 * i / mass : 0);
  }
}

}  // namespace
}  // namespace rouleau::effects
