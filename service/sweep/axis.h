#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rouleau::service {

/// One value of a case that a sweep varies.
struct Axis {
  std::string pointer;  ///< JSON Pointer into the case
  std::vector<nlohmann::json> values;
};

enum class SweepMode {
  grid,  ///< every combination, the last axis fastest
  zip,   ///< the k-th values of all axes together
};

/// `count` values, evenly apart; the first is exactly `from` and the last exactly `to`. One alone is `from`.
std::vector<double> evenly_spaced(double from, double to, std::size_t count);

/// How many points the axes span; nothing if that is more than `most`.
std::optional<std::size_t> point_count(const std::vector<Axis>& axes, SweepMode mode, std::size_t most);

/// Which value each axis has at a point: one index an axis.
std::vector<std::size_t> choice_at(const std::vector<Axis>& axes, SweepMode mode, std::size_t point);

}  // namespace rouleau::service
