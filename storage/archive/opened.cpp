#include "storage/archive/opened.h"

namespace rouleau::storage {

hdf5::File open_archive(const std::filesystem::path& path) {
  hdf5::File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (file.get() >= 0) return file;
  const ArchiveError error = hdf5::last_error("cannot open " + path.string());
  file = hdf5::File(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, H5P_DEFAULT));
  if (file.get() < 0) throw error;
  return file;
}

}  // namespace rouleau::storage
