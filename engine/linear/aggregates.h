#pragma once

#include <span>
#include <vector>

namespace rouleau::linear {

/// Which aggregate each row of a matrix is in, from 0. Rows that are coupled are in the same aggregate or in
/// two whose numbers differ by at most the bandwidth.
struct Aggregates {
  std::vector<int> of;  ///< [rows]
  int count = 0;
  int bandwidth = 0;
};

/// Aggregates of points by the cells of a square grid over their bounding box, in a periodic direction over
/// the period, empty cells left out, numbered along the shorter side first.
class GridAggregates {
 public:
  /// @param width  of a cell, at least the reach of a coupling; adjusted to divide the box
  /// @param period_x, period_y  0: not periodic
  GridAggregates(double width, double period_x, double period_y)
      : width_(width), period_x_(period_x), period_y_(period_y) {}

  const Aggregates& build(std::span<const double> x, std::span<const double> y);

 private:
  struct Side {
    double low = 0;
    double per_width = 0;
    int cells = 1;
    double period = 0;
    int cell(double at) const;
  };
  Side side(std::span<const double> at, double period) const;

  double width_;
  double period_x_, period_y_;
  std::vector<int> number_;  ///< of a cell
  Aggregates aggregates_;
};

}  // namespace rouleau::linear
