#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case.h"
#include "service/sweep/sweep_body.h"

namespace rouleau::service {

/// One point of a sweep: a case that can be run.
struct SweepPoint {
  std::vector<std::size_t> choice;  ///< which value of each axis
  std::string given;                ///< the case with these values, JSON
  Case resolved;
};

/// All points in their order.
/// @throws Problem 422 invalid-case naming every bad point with its index, its values and what is wrong
std::vector<SweepPoint> expand(const SweepBody& sweep);

/// The values of a point, one an axis.
std::vector<nlohmann::json> values_at(const SweepBody& sweep, const std::vector<std::size_t>& choice);

}  // namespace rouleau::service
