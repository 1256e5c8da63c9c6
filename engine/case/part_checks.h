#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"
#include "engine/case/faults.h"

namespace rouleau {

/// Adds a fault for every part of a case that does not go with another one, such as an inflow into a closed
/// box.
/// @param given  the sound part of the document that `scene` was read from: says what is there and what is a
///               default
void check_parts(const nlohmann::json& given, const Case& scene, Faults& faults);

}  // namespace rouleau
