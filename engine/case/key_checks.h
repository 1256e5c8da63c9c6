#pragma once

#include <string>

#include "engine/case/case_keys.h"
#include "engine/case/faults.h"

namespace rouleau {

/// Checks a value and all below it against its key, adding every fault found.
/// @return the sound part of it: unknown keys and faulty values left out, objects in lists at their places;
///         null if nothing is sound
nlohmann::json sound_part(const nlohmann::json& value, const Key& key, const std::string& pointer,
                          Faults& faults);

}  // namespace rouleau
