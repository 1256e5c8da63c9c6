#pragma once

#include <filesystem>

#include "storage/hdf5/handle.h"

namespace rouleau::storage {

/// An HDF5 file on its way to its final name. It is removed unless it gets there. All but `publish` belongs
/// within a Session.
class UnfinishedFile {
 public:
  UnfinishedFile(std::filesystem::path aside, std::filesystem::path final_name);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  hid_t id() const { return file_.get(); }
  const std::filesystem::path& path() const { return aside_; }

  /// From here on other programs may read while we write (SWMR), and no new objects can be made.
  void let_others_read();
  void flush();
  /// Ends `let_others_read`. Everything made in the file must be closed.
  void reopen();
  void close();
  /// What HDF5 still wants to write is forgotten. On a full disk it would otherwise fail to close the file,
  /// keep it, and try again until the process ends.
  void give_up();

  void publish();

 private:
  std::filesystem::path aside_, final_name_;
  hdf5::File file_;
  bool published_ = false;
};

}  // namespace rouleau::storage
