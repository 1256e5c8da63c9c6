#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/job.h"

namespace rouleau::storage {

/// A file of a data folder in a backup, where it is kept under its content's name.
struct ManifestFile {
  std::string path;  ///< in the data folder: jobs.sqlite, archives/ID.h5
  std::uint64_t size = 0;
  std::string sha256;
};

/// What a backup holds. It is written last: a backup without one, or with one that names what is not there,
/// was not finished.
struct Manifest {
  TimeMs created_at = 0;
  std::string engine;  ///< version of the program that made it
  int schema = 0;
  std::int64_t jobs = 0;
  std::vector<ManifestFile> files;
  std::vector<std::string> missing;  ///< archives that jobs have, which were gone or damaged
};

inline constexpr std::string_view manifest_name = "manifest.json";
inline constexpr std::string_view database_name = "jobs.sqlite";

std::filesystem::path manifest_path(const std::filesystem::path& backup);
/// Where a backup keeps a content.
std::filesystem::path content_path(const std::filesystem::path& backup, const std::string& sha256);

/// Written aside, and under its name once it is on the disk.
/// @throws ArchiveError
void write_manifest(const std::filesystem::path& backup, const Manifest& manifest);

/// @throws ArchiveError if there is none, or one that no backup of ours has
Manifest read_manifest(const std::filesystem::path& backup);

}  // namespace rouleau::storage
