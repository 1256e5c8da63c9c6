#pragma once

#include <cstddef>
#include <string>

#include "service/sweep/sweep_table.h"

namespace rouleau::service {

/// Peak tau and peak velocity of the first cell against the first axis, a line for each value of the second,
/// as SVG. Empty where that would show nothing: with more axes, with values that are no numbers, without a
/// cell, or with fewer than two points.
std::string draw_sweep(const SweepTable& table, std::size_t axes);

}  // namespace rouleau::service
