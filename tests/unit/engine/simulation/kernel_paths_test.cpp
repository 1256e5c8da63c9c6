#include <gtest/gtest.h>

#include "engine/simd/kernels.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/same_particles.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

particles::ParticleSet after_steps(const Case& scene, simd::Path path) {
  const simd::Path before = simd::path();
  simd::choose(path);
  Simulation simulation(scene);
  for (int k = 0; k < 12; ++k) simulation.step();
  simd::choose(before);
  return simulation.state().particles;
}

TEST(KernelPaths, GiveTheSameBits) {
  if (!simd::available(simd::Path::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  for (const Case& scene : {coarse_vessel(), coarse_vessel_with_cells()}) {
    expect_same_particles(after_steps(scene, simd::Path::plain), after_steps(scene, simd::Path::avx2));
  }
}

}  // namespace
}  // namespace rouleau
