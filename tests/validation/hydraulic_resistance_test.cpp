#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/validation/recorded_run.h"
#include "tests/validation/references.h"

namespace rouleau::validation {
namespace {

constexpr double height = 10e-6, viscosity = 1e-3;

/// A circle that neither its membrane nor its area lets change much: nearly a rigid cylinder, however its
/// inside turns.
Case floating_cylinder(const nlohmann::json& exact) {
  Case scene;
  scene.vessel = {3 * height, height};
  scene.vessel.ends = Ends::periodic;
  scene.body_acceleration = {600, 0};
  RedCell cell;
  cell.x = 1.5 * height;
  cell.y = exact.at("y").get<double>() * height;
  cell.diameter = 2 * exact.at("radius").get<double>() * height;
  cell.fill = 1;
  cell.shape = CellShape::circle;
  cell.stretch_modulus = 1e-2;
  scene.cells = {cell};
  scene.numerics.spacing = height / 50;
  scene.duration = 5e-4;
  scene.effects["hydraulic_resistance"] = {Switch::on};
  return scene;
}

/// Over the last third of the run.
double mean_at_end(const RecordedRun& run, const std::string& name) {
  const auto values = run.column(name);
  double sum = 0;
  const std::size_t from = 2 * values.size() / 3;
  for (std::size_t k = from; k < values.size(); ++k) sum += values[k];
  return sum / static_cast<double>(values.size() - from);
}

// The errors fall with the spacing (docs/effects/hydraulic_resistance.md): at H/50 up to a tenth.
class FloatingCylinder : public testing::TestWithParam<const char*> {};

TEST_P(FloatingCylinder, AddsTheResistanceOfStokesFlow) {
  const nlohmann::json& exact = reference("rigid_cylinder_in_channel").at(GetParam());
  const RecordedRun run(floating_cylinder(exact));
  const double unit = viscosity / (height * height);
  const double expected = exact.at("extra_pressure_drop").get<double>() * unit;
  EXPECT_DOUBLE_EQ(mean_at_end(run, "resistance_free"), 36 * unit);
  EXPECT_NEAR(mean_at_end(run, "cell0.resistance"), expected, 0.1 * expected);
  EXPECT_NEAR(mean_at_end(run, "resistance") - 36 * unit, expected, 0.12 * expected);
  const double velocity = mean_at_end(run, "cell0.u") / (mean_at_end(run, "inflow") / height);
  EXPECT_NEAR(velocity, exact.at("velocity").get<double>(), 0.01 * velocity);
}

INSTANTIATE_TEST_SUITE_P(InAChannel, FloatingCylinder, testing::Values("axis", "aside"));

}  // namespace
}  // namespace rouleau::validation
