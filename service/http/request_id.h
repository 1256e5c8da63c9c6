#pragma once

#include <string>

namespace rouleau::service {

/// 16 hex digits, made here: never what a client sent.
std::string new_request_id();

}  // namespace rouleau::service
