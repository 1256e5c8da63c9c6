#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "engine/plan/plan.h"
#include "service/http/problem.h"
#include "service/known_machine.h"

namespace rouleau::service {

/// A body as JSON, within the bounds on cases.
/// @throws Problem 400 invalid-json
nlohmann::json read_body(const std::string& body);

struct PlannedCase {
  Case resolved;
  Plan plan;
};

/// Reads and plans a case, for the machine if one is given.
/// @param pointer  where the case stands in the body; stands before the pointer of every fault
/// @throws Problem 422 invalid-case with every fault
PlannedCase plan_case(const nlohmann::json& document, const std::string& pointer,
                      KnownMachine* machine = nullptr);

}  // namespace rouleau::service
