#pragma once

#include <filesystem>

#include "engine/simulation/checkpoint.h"
#include "engine/simulation/output.h"

namespace rouleau::storage {

/// Whether an archive, finished or not, has what was delivered to it until a checkpoint.
/// @throws ArchiveError if it cannot be read
bool can_replay(const std::filesystem::path& archive, const CheckpointHead& head);

/// Delivers that again, rows and frames in the order of their times, as the run did.
/// @throws ArchiveError
void replay(const std::filesystem::path& archive, const CheckpointHead& head, Output& output);

}  // namespace rouleau::storage
