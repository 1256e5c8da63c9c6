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

/// Aggregates of points by the cells of a square grid over their bounding box, empty cells left out, numbered
/// along the shorter side first.
class GridAggregates {
 public:
  /// @param width  of a cell, at least the reach of a coupling; adjusted to divide the box
  /// @param periodic_x, periodic_y  whether rows are coupled across the box's ends
  GridAggregates(double width, bool periodic_x, bool periodic_y)
      : width_(width), periodic_x_(periodic_x), periodic_y_(periodic_y) {}

  const Aggregates& build(std::span<const double> x, std::span<const double> y);

 private:
  struct Side {
    double low = 0;
    double per_width = 0;
    int cells = 1;
    int cell(double at) const;
  };
  Side side(std::span<const double> at) const;

  double width_;
  bool periodic_x_, periodic_y_;
  std::vector<int> number_;  ///< of a cell
  Aggregates aggregates_;
};

}  // namespace rouleau::linear
