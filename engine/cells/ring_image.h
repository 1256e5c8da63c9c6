#pragma once

#include <vector>

#include "engine/cells/link_boxes.h"

namespace rouleau::cells {

/// A copy of a ring, displaced: the image of a cell beyond the seam of a periodic vessel.
class RingImage {
 public:
  RingImage(Ring ring, double away_x, double away_y)
      : x_(displaced(ring.x, away_x)), y_(displaced(ring.y, away_y)), boxes_(Ring{x_, y_}) {}
  RingImage(const RingImage&) = delete;
  RingImage& operator=(const RingImage&) = delete;

  const LinkBoxes& boxes() const { return boxes_; }

 private:
  static std::vector<double> displaced(std::span<const double> positions, double away) {
    std::vector<double> moved(positions.begin(), positions.end());
    for (double& position : moved) position += away;
    return moved;
  }

  std::vector<double> x_, y_;
  LinkBoxes boxes_;
};

}  // namespace rouleau::cells
