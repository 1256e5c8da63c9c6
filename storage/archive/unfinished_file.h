#pragma once

#include <filesystem>

#include "storage/hdf5/handle.h"

namespace rouleau::storage {

/// An HDF5 file on its way to its final name. It is removed unless it gets there or is to be kept. All but
/// `publish` belongs within a Session.
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
  /// A checkpoint relies on what is in the file by now: whatever happens, it stays until `publish`.
  void keep() { kept_ = true; }
  /// Ends `let_others_read`. Everything made in the file must be closed. Whoever is killed from here until
  /// `close` leaves a file that nobody can open: one to be kept is finished in a copy.
  void reopen();
  void close();
  /// What HDF5 still wants to write is forgotten. On a full disk it would otherwise fail to close the file,
  /// keep it, and try again until the process ends.
  void give_up();

  void publish();

 private:
  std::filesystem::path aside_, final_name_;
  std::filesystem::path copied_from_;  // the file to be kept, once it is being finished in a copy
  hdf5::File file_;
  bool kept_ = false;
  bool published_ = false;
};

}  // namespace rouleau::storage
