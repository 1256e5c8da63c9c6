#pragma once

#include <filesystem>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

namespace rouleau::storage {

/// Limits how large a file of this process may become; what is beyond fails as it does on a quota, once
/// SIGXFSZ is ignored.
inline void limit_file_size(rlim_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// A file system of one megabyte, seen by this process alone. False where the system does not let us mount.
inline bool mount_small_disk(const std::filesystem::path& folder) {
  return unshare(geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) == 0 &&
         mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         mount("none", folder.c_str(), "tmpfs", 0, "size=1m") == 0;
}

}  // namespace rouleau::storage
