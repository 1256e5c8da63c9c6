#pragma once

#include <nlohmann/json_fwd.hpp>

#include "service/queue/live_jobs.h"
#include "storage/job.h"

namespace rouleau::service {

/// A job as lists show it: without its plan and its case. While it runs, its progress is the live one.
nlohmann::json to_json(const storage::Job& job, const LiveJobs& live);

}  // namespace rouleau::service
