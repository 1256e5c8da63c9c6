#pragma once

#include <vector>

#include "engine/geometry/shapes.h"

namespace rouleau::geometry {

/// A node on the true wall surface.
struct WallNode {
  double x = 0, y = 0;
  double nx = 0, ny = 0;      ///< unit normal into the fluid (at a corner the bisector)
  double u = 0, v = 0;        ///< velocity of the wall there
  double length = 0;          ///< of the wall that it stands for: half the way to each of its neighbours
  bool beyond_inlet = false;  ///< on the extension upstream of the inlet plane
  bool torn = false;          ///< in a corner whose walls move apart; at rest, but no velocity is right
};

/// Appends the nodes of one chain. Every piece is divided evenly, into steps as near to `spacing` as can be
/// (an arc into two at least); a chain that is no loop starts and ends with a straight piece, which is
/// drawn out by `extension` first.
void add_nodes(const WallChain& chain, double spacing, double extension, std::vector<WallNode>& nodes);

}  // namespace rouleau::geometry
