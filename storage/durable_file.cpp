#include "storage/durable_file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include "storage/archive_error.h"

namespace rouleau::storage {

namespace {

ArchiveError failure(const std::filesystem::path& path) {
  const bool full = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  return ArchiveError(full ? ArchiveError::Kind::disk_full : ArchiveError::Kind::io,
                      path.string() + ": " + std::generic_category().message(errno));
}

}  // namespace

void sync(const std::filesystem::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw failure(path);
  const bool done = fsync(descriptor) == 0;
  const ArchiveError error = failure(path);
  close(descriptor);
  if (!done) throw error;
}

void publish(const std::filesystem::path& aside, const std::filesystem::path& final_name) {
  sync(aside);
  if (std::rename(aside.c_str(), final_name.c_str()) != 0) throw failure(final_name);
  sync(final_name.has_parent_path() ? final_name.parent_path() : ".");
}

void copy(const std::filesystem::path& file, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::copy_file(file, to, std::filesystem::copy_options::overwrite_existing, error);
  if (!error) return;
  errno = error.value();
  throw failure(to);
}

}  // namespace rouleau::storage
