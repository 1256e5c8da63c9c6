#pragma once

#include <optional>

#include "engine/cells/link_boxes.h"
#include "engine/geometry/outline.h"

namespace rouleau::cells {

/// Least distance between two rings that do not cross, segment to segment: it is found at a node of one of
/// them.
double least_gap(const LinkBoxes& a, const LinkBoxes& b);

/// Least distance of a ring from the walls, segments between two nodes included; negative if a node is behind
/// one, infinite where there are no walls.
double wall_gap(Ring ring, const geometry::Outline& outline);

/// Two links that cross.
struct Crossing {
  std::size_t link_a, link_b;
  double x, y;  ///< where
};

/// The first one of the links of `a` with those of `b`.
std::optional<Crossing> find_crossing(const LinkBoxes& a, const LinkBoxes& b);
/// Of a ring with itself; links that share a node are left out.
std::optional<Crossing> find_crossing(const LinkBoxes& ring);

}  // namespace rouleau::cells
