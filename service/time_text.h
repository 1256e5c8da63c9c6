#pragma once

#include <string>

#include "storage/job.h"

namespace rouleau::service {

/// RFC 3339, UTC, with milliseconds.
std::string format_time(storage::TimeMs time);

}  // namespace rouleau::service
