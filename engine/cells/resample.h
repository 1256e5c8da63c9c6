#pragma once

#include <span>
#include <vector>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// Where `count` equal steps along a ring lead to, from node 0 on: a place of 3.25 is a quarter of the way
/// from node 3 to the next.
/// @param lengths  [nodes] of the links, by whatever measure the steps are to be equal in
std::vector<double> equal_steps(std::span<const double> lengths, int count);

/// Values of the nodes [at least four] at places, by the cubic through the four nodes around each.
std::vector<double> interpolate(std::span<const double> values, std::span<const double> places);

/// How much of the measure `lengths` [nodes] lies between each place and the next, around the ring.
std::vector<double> between(std::span<const double> lengths, std::span<const double> places);

std::vector<double> link_lengths(Ring ring);

}  // namespace rouleau::cells
