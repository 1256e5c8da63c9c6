#pragma once

#include <filesystem>

#include "storage/archive_error.h"
#include "storage/hdf5/handle.h"
#include "storage/hdf5/session.h"

namespace rouleau::storage {

/// Opens an archive to read it, one that its writer never finished, too: that bears the mark of a file that
/// is being written. Within a Session.
hdf5::File open_archive(const std::filesystem::path& path);

/// Runs `read(file)` with the archive open.
template <class Read>
auto opened(const std::filesystem::path& path, Read&& read) {
  const hdf5::Session session;
  const hdf5::File file = open_archive(path);
  try {
    return read(file.get());
  } catch (const ArchiveError& error) {
    throw ArchiveError(error.kind(), path.string() + ": " + error.what());
  }
}

}  // namespace rouleau::storage
