#include "engine/observe/hemolysis.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

Case with_hemolysis() {
  Case scene = coarse_vessel_with_cells();
  scene.effects["hemolysis"] = {Switch::on};
  return scene;
}

TEST(Hemolysis, OfConstantStressIsThePowerLaw) {
  const HemolysisLaw law = hemolysis_law(with_hemolysis());
  // The law as printed, in percent: 3.62e-5 t^0.785 tau^2.416.
  const double expected = 3.62e-5 * std::pow(0.5, 0.785) * std::pow(200, 2.416) / 100;
  double dose = 0;
  for (int k = 0; k < 1000; ++k) dose += law.dose(200, 0.5 / 1000);
  EXPECT_NEAR(law.index(dose), expected, 1e-12 * expected);
}

TEST(Hemolysis, DosesAddUpInAnyOrder) {
  const HemolysisLaw law = hemolysis_law(with_hemolysis());
  const double first = law.dose(100, 0.02), second = law.dose(10, 0.3);
  EXPECT_EQ(law.index(first + second), law.index(second + first));
  EXPECT_GT(law.index(first + second), law.index(first));
  // From an index the law goes on as if the present stress had made it.
  const double time_to_same =
      std::pow(law.index(first) / (law.factor * std::pow(10, law.stress_exponent)), 1 / law.time_exponent);
  const double expected =
      law.factor * std::pow(10, law.stress_exponent) * std::pow(time_to_same + 0.3, law.time_exponent);
  EXPECT_NEAR(law.index(first + second), expected, 1e-12 * expected);
}

TEST(Hemolysis, TakesTheConstantsOfTheCase) {
  Case scene = with_hemolysis();
  scene.effects["hemolysis"].parameters = {
      {"factor", 1.228e-7}, {"stress_exponent", 1.9918}, {"time_exponent", 0.6606}};
  const HemolysisLaw law = hemolysis_law(scene);
  const double zhang = 1.228e-7 * std::pow(100, 1.9918) * std::pow(0.1, 0.6606);
  EXPECT_NEAR(law.index(law.dose(100, 0.1)), zhang, 1e-12 * zhang);
}

TEST(Hemolysis, GrowsAlongThePathAndWarns) {
  Recorder recorder;
  const RunSummary summary = run_case(with_hemolysis(), recorder);
  const auto& columns = recorder.header.columns;
  const auto place = [&](const char* name) {
    const auto at =
        std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    EXPECT_NE(at, columns.end());
    return static_cast<std::size_t>(at - columns.begin());
  };
  const std::size_t index = place("cell0.hemolysis"), stress = place("cell0.scalar_shear_stress");
  EXPECT_EQ(recorder.rows.front()[index], 0);
  for (std::size_t k = 1; k < recorder.rows.size(); ++k) {
    EXPECT_GT(recorder.rows[k][index], recorder.rows[k - 1][index]);
    // The plasma's wall shear stress is 3 Pa.
    EXPECT_GT(recorder.rows[k][stress], 0.3);
    EXPECT_LT(recorder.rows[k][stress], 10);
  }
  const HemolysisLaw law = hemolysis_law(with_hemolysis());
  const double of_mean = law.index(law.dose(recorder.rows.back()[stress], recorder.rows.back()[0]));
  EXPECT_NEAR(recorder.rows.back()[index], of_mean, 0.5 * of_mean);
  ASSERT_FALSE(summary.warnings.empty());
  EXPECT_NE(summary.warnings.back().find("below that calibration"), std::string::npos);
}

}  // namespace
}  // namespace rouleau::observe
