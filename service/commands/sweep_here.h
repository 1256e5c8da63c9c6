#pragma once

#include <cstddef>
#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "service/sweep/sweep_body.h"

namespace rouleau::service {

struct SweepHereOptions {
  int workers = 1;
  double checkpoint_interval = 60;  ///< s
  std::size_t most_points = default_most_points;
};

/// Runs a sweep in this process, with its archives and its table in a folder.
/// @return the exit code
int sweep_here(const nlohmann::json& given, const std::filesystem::path& folder,
               const SweepHereOptions& options, bool json);

}  // namespace rouleau::service
