#include "engine/error/simulation_error.h"

#include <gtest/gtest.h>

namespace rouleau {
namespace {

TEST(SimulationError, SaysWhatWhenAndWhere) {
  const SimulationError error({.quantity = "speed",
                               .value = 0.25,
                               .bound = 0.15,
                               .unit = "m/s",
                               .time = 1.5e-3,
                               .step = 120,
                               .x = 12e-6,
                               .y = 3e-6,
                               .particle = 4711,
                               .cell = 1});
  const std::string text = error.what();
  for (const char* part :
       {"speed", "0.25", "0.15 m/s", "1.5 ms", "step 120", "12 um", "3 um", "4711", "cell 1"}) {
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
  }
  EXPECT_EQ(error.breach().particle, 4711);
}

TEST(SimulationError, OfAWholeCellNamesTheCellAndItsPlace) {
  const SimulationError error(
      {.quantity = "area", .value = 1, .unit = "1", .x = 12e-6, .y = 3e-6, .cell = 2});
  const std::string text = error.what();
  for (const char* part : {"12 um", "3 um", ", cell 2"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(text.find("particle"), std::string::npos);
}

TEST(SimulationError, OfTheWholeRunNamesNoParticle) {
  const SimulationError error({.quantity = "residual", .value = 1, .bound = 0.1, .unit = "1"});
  EXPECT_EQ(std::string(error.what()).find("particle"), std::string::npos);
}

}  // namespace
}  // namespace rouleau
