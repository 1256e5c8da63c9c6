#include "storage/archive/opened.h"

namespace rouleau::storage {

namespace {

// Reading what another program is just writing is tried again, each time after twice the pause. HDF5's own
// 100 tries would never end on a file that is torn; these take a tenth of a second.
constexpr unsigned most_tries = 25;

hdf5::Properties patient() {
  hdf5::Properties access(hdf5::checked(H5Pcreate(H5P_FILE_ACCESS), "file access"));
  hdf5::checked(H5Pset_metadata_read_attempts(access.get(), most_tries), "file access");
  return access;
}

}  // namespace

hdf5::File open_archive(const std::filesystem::path& path) {
  hdf5::File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (file.get() >= 0) return file;
  const ArchiveError error = hdf5::last_error("cannot open " + path.string());
  file = hdf5::File(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, patient().get()));
  if (file.get() < 0) throw error;
  return file;
}

}  // namespace rouleau::storage
