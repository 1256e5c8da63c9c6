#pragma once

#include <filesystem>

#include "service/api/service.h"
#include "service/http/guarded_server.h"
#include "service/metrics.h"

namespace rouleau::service {

/// Reads what is not counted. What cannot be read is 0.
/// @param data the data folder
MetricsNow read_metrics(const Service& service, std::size_t connections, const std::filesystem::path& data);

}  // namespace rouleau::service
