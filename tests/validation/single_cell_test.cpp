#include "engine/cells/shape.h"
#include "tests/validation/recorded_run.h"

namespace rouleau::validation {

namespace {

RedCell study_cell() {
  RedCell cell;
  cell.x = 16e-6;
  cell.y = 5e-6;
  return cell;
}

/// Particles of a frame that are on the wrong side of a cell's membrane.
int on_the_wrong_side(const Frame& frame, int cell, int nodes) {
  std::vector<double> x, y;
  int wrong = 0;
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    if (frame.kind[i] == ParticleKind::membrane && frame.cell[i] == cell) {
      x.push_back(frame.x[i]);
      y.push_back(frame.y[i]);
    }
  }
  EXPECT_EQ(static_cast<int>(x.size()), nodes);
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    if (frame.kind[i] == ParticleKind::membrane) continue;
    const bool inside = cells::contains({x, y}, frame.x[i], frame.y[i]);
    wrong += inside != (frame.kind[i] == ParticleKind::inside && frame.cell[i] == cell);
  }
  return wrong;
}

// A membrane ten times as stiff in stretch as the study's, in the free vessel, against a boundary-integral
// calculation that is itself given as within 1.5 %.
TEST(SingleCell, FreeVesselVelocityMatchesTheBoundaryIntegral) {
  Case scene = study_vessel(2.9e-3);
  scene.cells.push_back(study_cell());
  scene.cells[0].stretch_modulus = 1e-4;
  const RecordedRun run(scene);
  EXPECT_NEAR(run.where("cell0.x", 20e-6, "cell0.u") / 0.005, 1.174, 0.03 * 1.174);
  EXPECT_NEAR(run.where("cell0.x", 32e-6, "cell0.u") / 0.005, 1.224, 0.03 * 1.224);
}

// Section 3.1 with the 8 d0 thrombus until the cell is past it: the study's full 9 ms is run by the
// reproduction, not here.
TEST(SingleCell, SqueezesPastTheThrombusWithoutLeaking) {
  Case scene = study_vessel(3e-3);
  scene.thrombi.push_back({Wall::lower, 32e-6, 3.2e-6});
  scene.cells.push_back(study_cell());
  const RecordedRun run(scene);
  EXPECT_EQ(run.summary.ending, Ending::completed);
  EXPECT_LE(run.summary.cells[0].area_deviation, 0.005);
  EXPECT_LE(run.summary.volume_mismatch, 0.01);
  for (const Frame& frame : run.frames) {
    EXPECT_EQ(on_the_wrong_side(frame, 0, run.header.nodes_per_cell[0]), 0) << "at " << frame.time;
  }
  EXPECT_GT(run.column("cell0.x").back(), 34e-6);
  // No reference from elsewhere: this holds the scheme to itself, which has 8.11, 8.10 and 8.08e-3 at steps
  // of 3.6, 7.25 and 14.5 us, and 8.03 and 8.10e-3 at d0 = 0.5 and 0.25 um; the study has 7.2e-3.
  EXPECT_NEAR(run.summary.cells[0].peak_velocity, 8.05e-3, 0.02 * 8.05e-3);
  EXPECT_NEAR(run.summary.cells[0].peak_velocity_x, 31e-6, 2e-6);
}

}  // namespace

}  // namespace rouleau::validation
