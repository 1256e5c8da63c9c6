#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case_error.h"
#include "service/http/router.h"
#include "service/known_machine.h"
#include "storage/job.h"

namespace rouleau::service {

/// Reads the body of POST /v1/jobs: `{ "case": {...}, "priority"?, "labels"?, "fresh"? }`.
/// @throws Problem 400 or 422 with every fault
storage::NewJob read_new_job(const Call& call, KnownMachine& machine);

/// What a job and a sweep are given beside their case: priority, labels and whether to compute afresh.
storage::NewJob read_job_settings(const nlohmann::json& document, std::vector<Fault>& faults);

/// Among jobs of one priority the lanes take turns: the caller's, or else the one that label `lane` names.
/// @param labels JSON object of texts
std::string lane_of(const std::string& caller, const std::string& labels);

}  // namespace rouleau::service
