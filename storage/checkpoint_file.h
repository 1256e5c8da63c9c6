#pragma once

#include <filesystem>

#include "engine/simulation/output.h"

namespace rouleau::storage {

/// The checkpoint of the run that writes this archive: OUT.h5 -> OUT.h5.checkpoint.
std::filesystem::path checkpoint_path(const std::filesystem::path& archive);

/// Writes it aside, and under its name once it is on the disk: what has that name is whole, the last one
/// until then.
/// @throws ArchiveError
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// @throws CheckpointError if it is cut off or not as it was written, ArchiveError if it cannot be read
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace rouleau::storage
