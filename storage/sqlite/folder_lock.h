#pragma once

#include <filesystem>

namespace rouleau::storage {

/// Holds a folder for this process as long as it lives. The lock is the kernel's and goes with the process,
/// however that ends; the file `lock` in the folder only tells a person who has it.
class FolderLock {
 public:
  /// @throws StoreError naming the folder and the process that holds it
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace rouleau::storage
