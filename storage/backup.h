#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::storage {

struct BackupReport {
  std::int64_t jobs = 0;
  std::int64_t files = 0;              ///< in the backup
  std::int64_t added = 0;              ///< of these, that the backup before had not
  std::uint64_t bytes = 0;             ///< of all of them
  std::uint64_t added_bytes = 0;       ///< of those added
  std::vector<std::string> missing{};  ///< archives that jobs have, which were gone or damaged
};

/// Copies a data folder, also while a service works on it: the job store through SQLite as it is at one
/// instant, then what its jobs have. Contents that the backup has from before are not copied again, and until
/// this one is finished that one stays as it was.
/// @param links  let archives be hard links where the file system allows it, as cheap as they are exposed to
///               whatever happens to that disk
/// @throws StoreError, ArchiveError
BackupReport back_up(const std::filesystem::path& data, const std::filesystem::path& backup, bool links);

struct RestoreReport {
  std::int64_t jobs = 0;
  std::int64_t files = 0;
  std::uint64_t bytes = 0;
  std::vector<std::string> missing{};  ///< as the backup says
};

/// Makes a data folder from a backup, every byte of it checked before the folder has its name.
/// @throws StoreError, ArchiveError with everything that is wrong; then there is no folder
RestoreReport restore(const std::filesystem::path& backup, const std::filesystem::path& data);

}  // namespace rouleau::storage
