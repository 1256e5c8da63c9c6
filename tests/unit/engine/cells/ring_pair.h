#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {

/// Two rings as one array of nodes, the first `split` of which are the first ring's.
struct RingPair {
  /// The second ring is displaced by (dx, dy).
  RingPair(const Nodes& a, const Nodes& b, double dx, double dy) : nodes(a), split(a.x.size()) {
    for (std::size_t i = 0; i < b.x.size(); ++i) {
      nodes.x.push_back(b.x[i] + dx);
      nodes.y.push_back(b.y[i] + dy);
    }
  }

  Ring first() const { return {{nodes.x.data(), split}, {nodes.y.data(), split}}; }
  Ring second() const {
    return {{nodes.x.data() + split, nodes.x.size() - split},
            {nodes.y.data() + split, nodes.y.size() - split}};
  }

  Nodes nodes;
  std::size_t split;
};

/// Two ragged rings, the second one to the right of the first by about `gap`.
inline RingPair neighbours(std::uint32_t seed, double gap) {
  const Nodes left = random_ring(seed), right = random_ring(seed + 1000);
  const auto far_right = std::ranges::max_element(left.x), far_left = std::ranges::min_element(right.x);
  const double dx = *far_right + gap - *far_left;
  const double dy = left.y[far_right - left.x.begin()] - right.y[far_left - right.x.begin()];
  return {left, right, dx, dy};
}

/// A horizontal band: `n` links of length `link` below, and back above.
inline Nodes band(double y, int n, double link = 0.5) {
  Nodes nodes;
  for (int i = 0; i <= n; ++i) {
    nodes.x.push_back(link * i);
    nodes.y.push_back(y);
  }
  for (int i = n; i >= 0; --i) {
    nodes.x.push_back(link * i);
    nodes.y.push_back(y + 2);
  }
  return nodes;
}

}  // namespace rouleau::cells
