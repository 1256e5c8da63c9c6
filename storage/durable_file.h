#pragma once

#include <filesystem>

namespace rouleau::storage {

/// Returns once what was written to a file or folder is on the disk.
/// @throws ArchiveError
void sync(const std::filesystem::path& path);

/// Gives a file that was written aside its final name, for good: the content is on the disk before the name,
/// and the name before this returns.
/// @throws ArchiveError
void publish(const std::filesystem::path& aside, const std::filesystem::path& final_name);

/// Copies a file's content; what had the name of the copy is replaced.
/// @throws ArchiveError
void copy(const std::filesystem::path& file, const std::filesystem::path& to);

}  // namespace rouleau::storage
