#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/case/case.h"

namespace rouleau {

/// A straight side of the vessel, wall or open end, with the fluid on its left.
struct VesselSide {
  std::array<double, 2> from, to;  ///< m
  std::string name;                ///< as messages call it: "lower wall", "outlet"
};

/// A vessel without its thrombi as a closed polygon, counter-clockwise: what the checks of a scene take for
/// it before anything is computed.
struct VesselOutline {
  std::vector<VesselSide> sides;
  std::vector<std::size_t> lower, upper;  ///< sides that carry the thrombi of that wall, from the inlet on
  std::vector<std::size_t> inner;         ///< the branches' walls between the two outlets

  bool contains(const std::array<double, 2>& point) const;
  double area() const;  ///< m2
};

VesselOutline outline_of(const Vessel& vessel);

/// Where the inner walls of a bifurcation's branches meet: each is the branch's outer wall, which starts in
/// the corner at the trunk's end, shifted into the branch by its diameter. m
std::array<double, 2> apex_of(const Vessel& vessel);

}  // namespace rouleau
