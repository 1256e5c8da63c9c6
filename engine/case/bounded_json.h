#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/faults.h"

namespace rouleau {

/// No key of ours comes near this many bytes; a longer one would only blow up the answer.
inline constexpr std::size_t max_key_bytes = 256;

/// What `parse_json` does, but duplicate keys go to `faults` (the last value stands), so that they can be
/// reported together with what else is wrong.
/// @throws CaseError with everything in `faults` and the place where the text is no JSON
nlohmann::json parse_bounded(std::string_view text, Faults& faults);

}  // namespace rouleau
