#pragma once

#include <chrono>
#include <exception>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace rouleau::service {

/// Why an attempt at a job ended without a result.
struct Failure {
  enum class Kind { case_, engine, infrastructure };
  Kind kind = Kind::engine;
  nlohmann::json error;  ///< as the API's `error` has it
};

std::string_view to_string(Failure::Kind kind);

/// What an exception that a run threw means for its job.
Failure failure_of(const std::exception& error);

/// How long a job whose attempt an infrastructure error ended waits for the next one; none: there is no next
/// one.
/// @param setbacks  in a row, with this one; from 1
std::optional<std::chrono::seconds> retry_after(int setbacks);

}  // namespace rouleau::service
