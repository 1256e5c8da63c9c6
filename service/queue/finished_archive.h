#pragma once

#include <filesystem>
#include <optional>

#include "engine/case/case.h"
#include "storage/job.h"

namespace rouleau::service {

/// The result of a run of this very case and engine that completed and published its archive, though its job
/// does not know: its process died in between. None if there is no such archive.
std::optional<storage::JobResult> finished_result(const std::filesystem::path& archive, const Case& resolved);

}  // namespace rouleau::service
