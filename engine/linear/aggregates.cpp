#include "engine/linear/aggregates.h"

#include <algorithm>
#include <cmath>

namespace rouleau::linear {

namespace {

/// Numbers from both ends inwards (0, n - 1, 1, n - 2, ...), so that those which meet across the ends stay
/// close to one another: neighbours are then two apart.
int folded(int cell, int cells) {
  return 2 * cell < cells ? 2 * cell : 2 * (cells - 1 - cell) + 1;
}

}  // namespace

int GridAggregates::Side::cell(double at) const {
  if (period > 0) at -= period * std::floor(at / period);
  const double place = (at - low) * per_width;
  return place > 0 ? static_cast<int>(std::min(place, cells - 1.0)) : 0;
}

GridAggregates::Side GridAggregates::side(std::span<const double> at, double period) const {
  if (period > 0) {
    const double cells = std::max(1.0, std::round(period / width_));
    return {0, cells / period, static_cast<int>(cells), period};
  }
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  const double cells = std::round((*high - *low) / width_);
  if (!(cells > 1 && cells <= static_cast<double>(at.size()))) return {};
  return {*low, cells / (*high - *low), static_cast<int>(cells), 0};
}

const Aggregates& GridAggregates::build(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  aggregates_.of.resize(n);
  aggregates_.count = 0;
  aggregates_.bandwidth = 0;
  if (n == 0) return aggregates_;
  Side along_x = side(x, period_x_), along_y = side(y, period_y_);
  // More cells than points are of a run gone wrong: then one cell will do.
  if (static_cast<double>(along_x.cells) * along_y.cells > static_cast<double>(n)) along_x = along_y = {};
  const bool x_is_longer = along_x.cells >= along_y.cells;
  const Side& longer = x_is_longer ? along_x : along_y;
  const Side& shorter = x_is_longer ? along_y : along_x;
  const bool fold = longer.period > 0;
  const bool shorter_wraps = shorter.period > 0;
  const auto& place_along = x_is_longer ? x : y;
  const auto& place_across = x_is_longer ? y : x;

  constexpr int empty = -1, occupied = 0;
  number_.assign(static_cast<std::size_t>(longer.cells) * shorter.cells, empty);
  for (std::size_t i = 0; i < n; ++i) {
    const int a = longer.cell(place_along[i]);
    const int cell = (fold ? folded(a, longer.cells) : a) * shorter.cells + shorter.cell(place_across[i]);
    aggregates_.of[i] = cell;
    number_[cell] = occupied;
  }
  for (int& number : number_) {
    if (number == occupied) number = aggregates_.count++;
  }
  for (int& aggregate : aggregates_.of) aggregate = number_[aggregate];
  const int apart = shorter_wraps ? shorter.cells - 1 : 1;
  aggregates_.bandwidth =
      std::min((fold ? 2 : 1) * shorter.cells + std::min(apart, shorter.cells - 1), aggregates_.count - 1);
  return aggregates_;
}

}  // namespace rouleau::linear
