#pragma once

#include <string>

#include "service/known_machine.h"
#include "storage/job.h"

namespace rouleau::service {

/// Reads the body of POST /v1/jobs: `{ "case": {...}, "priority"?, "labels"? }`.
/// @throws Problem 400 or 422 with every fault
storage::NewJob read_new_job(const std::string& body, KnownMachine& machine);

}  // namespace rouleau::service
