#pragma once

#include <string>

#include "engine/case/case.h"

namespace rouleau::service {

/// SHA-256, in hex, of this engine's version and the resolved case without its name: with the same hash comes
/// the same result, to the last bit.
std::string case_hash(const Case& resolved);

}  // namespace rouleau::service
