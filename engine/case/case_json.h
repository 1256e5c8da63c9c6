#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"
#include "engine/case/case_error.h"

namespace rouleau {

/// Bounds on what is read at all, before any of it is believed.
inline constexpr std::size_t max_case_bytes = 1 << 20;
inline constexpr int max_case_depth = 16;

/// Parses text as JSON within `max_case_bytes` and `max_case_depth`; refuses duplicate keys, NaN, numbers
/// out of range and invalid UTF-8.
/// @throws CaseError naming the place
nlohmann::json parse_json(std::string_view text);

/// What a caller wants checked beside the case itself (`check_effects` of the plan): adds its faults, and
/// fills in the defaults that it knows of.
using CaseCheck = std::function<void(Case&, std::vector<Fault>&)>;

/// Reads a case strictly: unknown keys, wrong types, values out of range and scenes that contradict
/// themselves are faults, and so is what `further` finds in the sound part of the case; all of them are
/// reported at once.
/// @throws CaseError with every fault
Case read_case(std::string_view text, const CaseCheck& further = {});

/// The same of a document; a template only so that text is never taken for a JSON string.
template <std::same_as<nlohmann::json> Json>
Case read_case(const Json& document, const CaseCheck& further = {});

/// The case with every default filled in; `read_case(to_json(c))` gives `c` again.
nlohmann::json to_json(const Case& resolved);

/// The JSON Schema (draft 7) of a case, made from the same table of keys that `read_case` checks against.
const nlohmann::json& case_schema();

}  // namespace rouleau
