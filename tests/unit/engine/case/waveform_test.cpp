#include "engine/case/waveform.h"

#include <gtest/gtest.h>

namespace rouleau::testing {
namespace {

TEST(Waveform, WithoutPointsIsSteady) {
  EXPECT_EQ(waveform_factor(Inflow{}, 0), 1);
  EXPECT_EQ(waveform_factor(Inflow{}, 7), 1);
  EXPECT_EQ(largest_factor(Inflow{}), 1);
}

TEST(Waveform, IsLinearBetweenPointsAndHeldOutside) {
  const Inflow inflow{.waveform = {{1, 2}, {2, -4}, {4, 0}}};
  EXPECT_EQ(waveform_factor(inflow, 0), 2);
  EXPECT_EQ(waveform_factor(inflow, 1), 2);
  EXPECT_DOUBLE_EQ(waveform_factor(inflow, 1.25), 0.5);
  EXPECT_EQ(waveform_factor(inflow, 2), -4);
  EXPECT_DOUBLE_EQ(waveform_factor(inflow, 3.5), -1);
  EXPECT_EQ(waveform_factor(inflow, 4), 0);
  EXPECT_EQ(waveform_factor(inflow, 100), 0);
}

TEST(Waveform, OfOnePointIsHeldThroughout) {
  const Inflow inflow{.waveform = {{3, 0.5}}};
  for (const double time : {0.0, 3.0, 9.0}) EXPECT_EQ(waveform_factor(inflow, time), 0.5);
}

TEST(Waveform, ItsLargestFactorCountsReversedFlow) {
  EXPECT_EQ(largest_factor({.waveform = {{0, 1}, {1, -3}, {2, 2}}}), 3);
  EXPECT_EQ(largest_factor({.waveform = {{0, 0.25}}}), 0.25);
  EXPECT_EQ(largest_factor({.waveform = {{0, 0}}}), 0);
}

}  // namespace
}  // namespace rouleau::testing
