#include "tests/validation/references.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/validation/scenes.h"

namespace rouleau::validation {
namespace {

TEST(References, EverySceneHasOne) {
  for (const Scene& scene : scenes()) EXPECT_TRUE(reference(scene.reference).contains("kind")) << scene.name;
}

TEST(References, TheStartOfPoiseuilleFlowIsAsTabulated) {
  const auto& check = reference("poiseuille_start").at("check");
  EXPECT_NEAR(poiseuille_start(check.at("y"), check.at("t")), check.at("value").get<double>(), 5e-6);
}

TEST(References, FlowsFromRestBecomeTheSteadyOnes) {
  for (const double y : {0.1, 0.5, 0.8}) {
    EXPECT_LT(couette_start(y, 0.01), y);
    EXPECT_NEAR(couette_start(y, 3), y, 1e-12);
    EXPECT_NEAR(1.5 * poiseuille_start(y, 3), poiseuille(y), 1e-12);
  }
}

// Slow oscillation is the parabola at every phase; and at any number the walls hold the fluid and the mean is
// the one given.
TEST(References, OscillatingFlowHasItsFluxAndSticksToTheWalls) {
  for (const double number : {0.01, 2.5, 10.0}) {
    constexpr int panels = 2000;
    double mean = 0;
    for (int k = 0; k < panels; ++k) mean += womersley((k + 0.5) / panels, 0.7, number) / panels;
    EXPECT_NEAR(mean, std::sin(0.7), 1e-5) << number;
    EXPECT_NEAR(womersley(0, 0.7, number), 0, 1e-12);
    EXPECT_NEAR(womersley(1, 0.7, number), 0, 1e-12);
  }
  EXPECT_NEAR(womersley(0.3, 0.7, 0.01), poiseuille(0.3) * std::sin(0.7), 1e-4);
}

TEST(References, BranchesThatAreAlikeShareAlike) {
  EXPECT_DOUBLE_EQ(network_share(1, 1, 1, 1), 0.5);
  EXPECT_DOUBLE_EQ(network_share(1, 2, 8, 1), 64.0 / 65);
}

}  // namespace
}  // namespace rouleau::validation
