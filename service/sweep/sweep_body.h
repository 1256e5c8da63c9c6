#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "service/sweep/axis.h"

namespace rouleau::service {

inline constexpr std::size_t default_most_points = 10'000;

/// A case and what of it is varied, as `{ "case", "axes", "mode"?, "name"? }` says it.
struct SweepBody {
  std::string name;  ///< its own, else the case's
  nlohmann::json scene;
  std::vector<Axis> axes;
  SweepMode mode = SweepMode::grid;
  std::size_t points = 0;
};

/// Reads a sweep as far as that goes without looking into its case. Members that `others` names are left to
/// the caller; `faults` are what the caller found in them, and are reported with those found here.
/// @throws Problem 400 invalid-request with every fault, 422 sweep-too-large
SweepBody read_sweep(const nlohmann::json& document, std::size_t most_points,
                     std::initializer_list<std::string_view> others, std::vector<Fault> faults = {});

}  // namespace rouleau::service
