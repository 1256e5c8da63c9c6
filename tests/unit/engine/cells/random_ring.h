#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "engine/cells/ring.h"

namespace rouleau::cells {

struct Nodes {
  std::vector<double> x, y;
  Ring ring() const { return {x, y}; }
};

/// A ragged, partly re-entrant ring that does not cross itself: its links are anything from crushed to
/// stretched for a rest length of 0.5, and it lies away from the origin.
inline Nodes random_ring(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int n = std::uniform_int_distribution<int>(6, 30)(random);
  const double cx = uniform(-20.0, 20.0), cy = uniform(-20.0, 20.0);
  const double radius = 0.5 * n / (2.0 * std::numbers::pi), flatness = uniform(0.4, 1.0);
  Nodes nodes;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + uniform(0.0, 0.8)) / n, r = radius * uniform(0.6, 1.4);
    nodes.x.push_back(cx + r * std::cos(angle));
    nodes.y.push_back(cy + flatness * r * std::sin(angle));
  }
  return nodes;
}

inline std::vector<double> random_vector(std::uint32_t seed, std::size_t size) {
  std::mt19937 random(seed);
  std::vector<double> values(size);
  for (double& value : values) value = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  return values;
}

}  // namespace rouleau::cells
