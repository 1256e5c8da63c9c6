#pragma once

#include <algorithm>
#include <ranges>
#include <vector>

#include "engine/effects/state.h"

namespace rouleau::effects {

/// Finds the particles around some, from their side, so that looking for them takes a time in proportion to
/// those, however many others there are.
class Neighbourhood {
 public:
  /// The active particles `seeds` and, in ascending order, all active ones that have one of them among their
  /// neighbours; with two hops those that have one of these among theirs, too, and so on. Valid until the
  /// next call.
  template <class Seeds>
  const std::vector<int>& around(const State& state, const Seeds& seeds, int hops = 1) {
    marked_.resize(static_cast<std::size_t>(state.particles.active_end()), 0);
    for (const int seed : seeds) mark(seed);
    std::size_t begin = 0;
    for (int hop = 0; hop < hops; ++hop) {
      const std::size_t found = found_.size();
      for (; begin < found; ++begin) mark_neighbours(state, found_[begin]);
    }
    for (const int i : found_) marked_[i] = 0;
    std::sort(found_.begin(), found_.end());
    around_.swap(found_);
    found_.clear();
    return around_;
  }

 private:
  void mark(int i) {
    if (marked_[i] != 0) return;
    marked_[i] = 1;
    found_.push_back(i);
  }

  void mark_neighbours(const State& state, int i) {
    const auto& list = state.neighbours;
    for (int k = list.begin(i); k < list.end(i); ++k) {
      if (list.j[k] < state.particles.active_end()) mark(list.j[k]);
    }
  }

  std::vector<char> marked_;
  std::vector<int> found_, around_;
};

/// All membrane nodes.
inline auto membrane_nodes(const State& state) {
  return std::views::iota(0, state.particles.membrane_end());
}

/// Those of a cell.
inline auto nodes_of(const CellState& cell) {
  return std::views::iota(cell.first_node, cell.first_node + cell.nodes);
}

}  // namespace rouleau::effects
