#include <cmath>

#include <gtest/gtest.h>

#include "engine/case/scales.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

/// The same flow, its lengths times `k`: plasma stays what it is, so velocities go with 1 / k and times
/// with k^2; the moduli go with rho U^2 D and rho U^2 D^3.
Case scaled(Case scene, double k) {
  const double velocity = 1 / k, time = k * k;
  scene.vessel.length *= k;
  scene.vessel.diameter *= k;
  scene.inflow.velocity *= velocity;
  for (WaveformPoint& point : scene.inflow.waveform) point.time *= time;
  for (double& pressure : scene.outflow.pressure) pressure *= velocity * velocity;
  for (double& a : scene.body_acceleration) a *= velocity / time;
  for (Branch& branch : scene.vessel.branches) branch = {branch.length * k, branch.diameter * k};
  WallVelocity& walls = scene.vessel.wall_velocity;
  for (double* wall : {&walls.lower, &walls.upper, &walls.left, &walls.right}) *wall *= velocity;
  scene.initial.velocity *= velocity;
  for (Thrombus& t : scene.thrombi) {
    t.x *= k;
    t.radius *= k;
  }
  for (RedCell& c : scene.cells) {
    c.x *= k;
    c.y *= k;
    c.diameter *= k;
    c.stretch_modulus *= velocity * velocity * k;
    c.bend_modulus *= velocity * velocity * k * k * k;
  }
  scene.numerics.spacing *= k;
  scene.duration *= time;
  scene.output.series_interval *= time;
  scene.output.frame_interval *= time;
  return scene;
}

double unit_of(const std::string& unit, const Scales& s) {
  if (unit == "m") return s.length;
  if (unit == "s") return s.time();
  if (unit == "m/s") return s.velocity;
  if (unit == "m2") return s.length * s.length;
  if (unit == "m2/s") return s.flux();
  if (unit == "Pa") return s.pressure();
  if (unit == "1/s") return 1 / s.time();
  return 1;
}

Case with_cell_and_thrombus() {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.length = 24e-6;
  scene.cells[0].angle = 60;  // clear of 90, where the axis flips sign
  scene.thrombi.push_back({Wall::lower, 16e-6, 3e-6});
  scene.outflow.pressure[0] = 2;
  return scene;
}

Case reversing() {
  Case scene = coarse_vessel();
  scene.inflow.waveform = {{0, 1}, {2e-4, -1}, {4e-4, 1}};
  return scene;
}

Case between_moving_walls() {
  Case scene = coarse_vessel();
  scene.vessel.ends = Ends::periodic;
  scene.vessel.wall_velocity = {-1e-3, 4e-3, 0, 0};
  scene.body_acceleration = {20, 0};
  return scene;
}

Case closed_box() {
  Case scene = coarse_vessel();
  scene.vessel.shape = Shape::box;
  scene.vessel.ends = Ends::closed;
  scene.vessel.wall_velocity.upper = 5e-3;
  scene.body_acceleration = {0, -9.81};
  return scene;
}

Case branching() {
  Case scene = coarse_vessel();
  scene.vessel.shape = Shape::bifurcation;
  scene.vessel.branches = {Branch{20e-6, 8e-6}, Branch{20e-6, 8e-6}};
  scene.outflow.pressure = {0, 1};
  return scene;
}

class ScaleInvariance : public testing::TestWithParam<Case (*)()> {};

TEST_P(ScaleInvariance, AThousandTimesSmallerOrLargerGivesTheSameNumbers) {
  const Case scene = GetParam()();
  Recorder one;
  run_case(scene, one);
  ASSERT_GT(one.rows.size(), 5u);
  // Powers of two, so that the scaled case is not already another one by its last digits: those come back
  // enlarged by the single precision of the weights, to 1e-8 or a little more with a factor of 1000.
  for (const double k : {0x1p-10, 0x1p10}) {
    const Case other_size = scaled(scene, k);
    Recorder other;
    run_case(other_size, other);
    ASSERT_EQ(one.rows.size(), other.rows.size());
    const auto& columns = one.header.columns;
    for (std::size_t row = 0; row < one.rows.size(); ++row) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const double value = one.rows[row][c] / unit_of(columns[c].unit, scales_of(scene));
        const double same = other.rows[row][c] / unit_of(columns[c].unit, scales_of(other_size));
        ASSERT_NEAR(same, value, 1e-8 * std::max(1.0, std::abs(value)))
            << columns[c].name << ", row " << row << ", scale " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ScaleInvariance,
                         testing::Values(with_cell_and_thrombus, reversing, between_moving_walls, closed_box,
                                         branching));

}  // namespace
}  // namespace rouleau
