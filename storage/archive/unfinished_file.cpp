#include "storage/archive/unfinished_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

#include "storage/durable_file.h"
#include "storage/hdf5/session.h"

namespace rouleau::storage {

namespace {

using hdf5::checked;

/// The newest format of files: its metadata has checksums, and SWMR needs it.
hdf5::Properties newest_format() {
  hdf5::Properties access(checked(H5Pcreate(H5P_FILE_ACCESS), "file access"));
  checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "file access");
  return access;
}

}  // namespace

UnfinishedFile::UnfinishedFile(std::filesystem::path aside, std::filesystem::path final_name)
    : aside_(std::move(aside)),
      final_name_(std::move(final_name)),
      file_(checked(H5Fcreate(aside_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, newest_format().get()),
                    "cannot create " + aside_.string())) {}

UnfinishedFile::~UnfinishedFile() {
  if (published_) return;
  give_up();
  file_.close();
  std::error_code ignored;
  if (!kept_ || !copied_from_.empty()) std::filesystem::remove(aside_, ignored);
}

void UnfinishedFile::let_others_read() {
  checked(H5Fstart_swmr_write(file_.get()), "cannot open " + aside_.string() + " to readers");
}

void UnfinishedFile::flush() {
  checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "cannot write " + aside_.string());
}

void UnfinishedFile::close() {
  flush();
  checked(file_.close(), "cannot close " + aside_.string());
}

void UnfinishedFile::reopen() {
  close();
  if (kept_) {
    copied_from_ = std::exchange(aside_, std::filesystem::path(final_name_) += ".ending.part");
    storage::copy(copied_from_, aside_);
  }
  file_ = hdf5::File(checked(H5Fopen(aside_.c_str(), H5F_ACC_RDWR, newest_format().get()),
                             "cannot reopen " + aside_.string()));
}

void UnfinishedFile::give_up() {
  void* descriptor = nullptr;
  if (file_.get() < 0 || H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &descriptor) < 0) return;
  const int nowhere = memfd_create("discarded archive", MFD_CLOEXEC);
  if (nowhere < 0) return;
  dup3(nowhere, *static_cast<int*>(descriptor), O_CLOEXEC);
  ::close(nowhere);
}

void UnfinishedFile::publish() {
  storage::publish(aside_, final_name_);
  published_ = true;
  std::error_code ignored;
  if (!copied_from_.empty()) std::filesystem::remove(copied_from_, ignored);
}

}  // namespace rouleau::storage
