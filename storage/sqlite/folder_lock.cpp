#include "storage/sqlite/folder_lock.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

std::string holder(int descriptor) {
  std::array<char, 32> text{};
  const ssize_t count = pread(descriptor, text.data(), text.size(), 0);
  const std::string pid(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  const auto digits = pid.find_first_not_of("0123456789");
  return digits == 0 || pid.empty() ? "another process" : "process " + pid.substr(0, digits);
}

StoreError system_failure(const std::filesystem::path& path) {
  return StoreError(StoreError::Kind::io, path.string() + ": " + std::generic_category().message(errno));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const auto path = folder / "lock";
  descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor_ < 0) throw system_failure(path);
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const StoreError error =
        errno == EWOULDBLOCK
            ? StoreError(StoreError::Kind::folder_in_use,
                         "the data folder " + folder.string() + " is in use by " + holder(descriptor_))
            : system_failure(path);
    close(descriptor_);
    throw error;
  }
  // Best effort: a full disk must not keep the service from starting.
  const std::string pid = std::to_string(getpid()) + "\n";
  [[maybe_unused]] const bool told =
      ftruncate(descriptor_, 0) == 0 && pwrite(descriptor_, pid.data(), pid.size(), 0) > 0;
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

}  // namespace rouleau::storage
