#include "engine/cells/resample.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

namespace rouleau::cells {
namespace {

constexpr double pi = std::numbers::pi;

/// An ellipse of 40 nodes at even angles: uneven links.
struct Ellipse {
  std::vector<double> x, y;

  Ellipse() {
    for (int k = 0; k < 40; ++k) {
      x.push_back(3 * std::cos(2 * pi * k / 40));
      y.push_back(std::sin(2 * pi * k / 40));
    }
  }
  Ring ring() const { return {x, y}; }
};

TEST(Resample, AsManyStepsOfTheNodesLeadToTheNodes) {
  const std::vector<double> even(40, 0.7);
  const auto places = equal_steps(even, 40);
  for (int k = 0; k < 40; ++k) EXPECT_NEAR(places[k], k, 1e-12);
  const Ellipse ellipse;
  const auto x = interpolate(ellipse.x, places);
  for (int k = 0; k < 40; ++k) EXPECT_NEAR(x[k], ellipse.x[k], 1e-10);
}

TEST(Resample, LinksBecomeEven) {
  const Ellipse ellipse;
  const auto places = equal_steps(link_lengths(ellipse.ring()), 90);
  const auto x = interpolate(ellipse.x, places), y = interpolate(ellipse.y, places);
  const auto lengths = link_lengths({x, y});
  const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) / 90;
  for (const double length : lengths) EXPECT_NEAR(length, mean, 0.05 * mean);
  for (int k = 0; k < 90; ++k) EXPECT_NEAR(x[k] * x[k] / 9 + y[k] * y[k], 1, 3e-4);
}

TEST(Resample, WhatLiesBetweenThePlacesAddsUp) {
  std::vector<double> measure;
  for (int k = 0; k < 40; ++k) measure.push_back(1 + 0.5 * std::sin(0.3 * k));
  const Ellipse ellipse;
  const auto parts = between(measure, equal_steps(link_lengths(ellipse.ring()), 73));
  EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0),
              std::accumulate(measure.begin(), measure.end(), 0.0), 1e-10);
  for (const double part : parts) EXPECT_GT(part, 0);
}

}  // namespace
}  // namespace rouleau::cells
