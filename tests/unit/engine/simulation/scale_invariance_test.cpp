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
  scene.outflow.pressure[0] *= velocity * velocity;
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
  return 1;
}

TEST(ScaleInvariance, AFlowAThousandTimesSmallerGivesTheSameNumbers) {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.length = 24e-6;
  scene.cells[0].angle = 60;  // clear of 90, where the axis flips sign
  scene.thrombi.push_back({Wall::lower, 16e-6, 3e-6});
  scene.outflow.pressure[0] = 2;
  const Case smaller = scaled(scene, 1e-3);
  Recorder one, other;
  run_case(scene, one);
  run_case(smaller, other);
  ASSERT_GT(one.rows.size(), 5u);
  ASSERT_EQ(one.rows.size(), other.rows.size());
  const auto& columns = one.header.columns;
  for (std::size_t row = 0; row < one.rows.size(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = one.rows[row][c] / unit_of(columns[c].unit, scales_of(scene));
      const double same = other.rows[row][c] / unit_of(columns[c].unit, scales_of(smaller));
      ASSERT_NEAR(same, value, 1e-8 * std::max(1.0, std::abs(value))) << columns[c].name << ", row " << row;
    }
  }
}

}  // namespace
}  // namespace rouleau
