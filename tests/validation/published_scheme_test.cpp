#include "engine/case/presets.h"
#include "engine/error/simulation_error.h"
#include "tests/validation/recorded_run.h"

namespace rouleau::validation {

namespace {

/// Section 2.5 of the study in its own scheme.
Case published_vessel(double duration) {
  Case scene = study_vessel(duration);
  scene.numerics = preset_numerics(Preset::paper);
  return scene;
}

// The scheme wanders by several percent, as rows of particles sliding past one another change the number
// density; the study prints 3.66 % for one moment.
TEST(PublishedScheme, CarriesTheParabolaAndKeepsItsParticles) {
  Case scene = published_vessel(2e-4);
  scene.effects["pressure_coarse_space"] = Switch::on;
  const RecordedRun run(scene);
  EXPECT_EQ(run.summary.steps, 400);
  EXPECT_LE(run.summary.poiseuille_deviation, 0.15);
  EXPECT_GE(run.summary.poiseuille_deviation, 0.005);
  const auto particles = run.column("particles");
  for (const double n : particles) EXPECT_NEAR(n, particles.front(), 0.01 * particles.front());
}

// Section 3.1 without a thrombus, the first 200 steps; the study's 9 ms are in docs/numerics.md.
TEST(PublishedScheme, CarriesACellAlongTheAxis) {
  Case scene = published_vessel(1e-4);
  RedCell cell;
  cell.x = 16e-6;
  cell.y = 5e-6;
  scene.cells.push_back(cell);
  scene.effects["pressure_coarse_space"] = Switch::on;
  const RecordedRun run(scene);
  EXPECT_EQ(run.summary.ending, Ending::completed);
  EXPECT_NEAR(run.column("cell0.y").back(), 5e-6, 1e-9);
  // Faster than the mean of the flow, slower than its axis.
  EXPECT_GT(run.column("cell0.u").back(), 0.005);
  EXPECT_LT(run.column("cell0.u").back(), 0.0075);
  // Forced one by one the nodes sink into their fluid at once, by 6 % of the area, and then hold.
  EXPECT_LE(run.summary.cells[0].area_deviation, 0.08);
  EXPECT_NEAR(run.column("cell0.tau").back(), 1, 0.01);
}

TEST(PublishedScheme, PlainGradientsGiveTheSameInManyMoreIterations) {
  Case scene = published_vessel(1e-5);
  const RecordedRun plain(scene);
  scene.effects["pressure_coarse_space"] = Switch::on;
  const RecordedRun coarse(scene);
  EXPECT_NEAR(plain.summary.poiseuille_deviation, coarse.summary.poiseuille_deviation, 1e-4);
  EXPECT_GE(plain.summary.pressure_iterations, 4 * coarse.summary.pressure_iterations);
}

TEST(PublishedScheme, AsPrintedBlowsUpAndSaysSo) {
  Case scene = published_vessel(2e-5);
  for (const char* change :
       {"density_source_relaxation", "wall_end_exclusion", "gradient_from_least_pressure"}) {
    scene.effects[change] = Switch::off;
  }
  EXPECT_THROW(RecordedRun run(scene), SimulationError);
  scene.effects = {{"density_source_relaxation", Switch::off}};
  EXPECT_THROW(RecordedRun run(scene), SimulationError);
}

}  // namespace

}  // namespace rouleau::validation
