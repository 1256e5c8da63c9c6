#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// What a cell looks like. The values are the codes in the time series.
enum class ShapeClass { other = 0, biconcave = 1, parachute = 2, slipper = 3, folded = 4 };
inline constexpr int shape_classes = 5;

std::string_view name_of(ShapeClass shape);

/// A part of the outline that its convex hull bridges.
struct Concavity {
  double depth;   ///< of the deepest node below the bridge
  double mouth;   ///< length of the bridge
  double nx, ny;  ///< unit normal out of the mouth
};

/// Those deeper than `least_depth`, in the order of the ring.
std::vector<Concavity> concavities(Ring ring, double least_depth);

/// How far a shape is from its mirror image in the line through its centroid along `axis` (any length but
/// 0): the area that only one of the two covers, over that of both. 0 is symmetric; at most 1.
double asymmetry(Ring ring, std::array<double, 2> axis);

/// With R the radius of the disc of the same area, of the concavities deeper than 0.02 R, and those that are
/// at least a quarter as deep as the deepest:
/// - folded: one is deeper than its mouth is wide, so that parts of the membrane face one another;
/// - biconcave: there are two, their mouths turned away from one another (within 45 degrees);
/// - parachute: there is one, its mouth turned along `motion` or against it (within 45 degrees), and the
///   asymmetry about `motion` is at most 0.1;
/// - slipper: there is one otherwise;
/// - other: the rest, such as convex shapes.
/// @param motion  the direction in which the cell moves
ShapeClass classify(Ring ring, std::array<double, 2> motion);

}  // namespace rouleau::cells
