#pragma once

#include <string>

#include "engine/plan/plan.h"

namespace rouleau::service {

/// A plan for a person: what will run, what is left out, what it will take.
std::string describe_plan(const Plan& plan);

}  // namespace rouleau::service
