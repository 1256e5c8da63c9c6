#include "storage/hdf5/array_reader.h"

#include "storage/hdf5/handle.h"
#include "storage/hdf5/session.h"

namespace rouleau::storage::hdf5 {

namespace {

// A damaged extent must not make us ask for more memory than any record of ours has.
constexpr hsize_t most_numbers = hsize_t{1} << 28;

Dataset opened(hid_t parent, const std::string& path) {
  return Dataset(checked(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), path));
}

std::vector<hsize_t> shape_of(const Dataspace& space, const std::string& path) {
  const int rank = checked(H5Sget_simple_extent_ndims(space.get()), path);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  checked(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), path);
  hsize_t record = 1;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (shape[i] > most_numbers) throw ArchiveError(ArchiveError::Kind::format, path + " is too large");
    if (i > 0) record *= shape[i];
    if (record > most_numbers) throw ArchiveError(ArchiveError::Kind::format, path + " is too large");
  }
  return shape;
}

bool is_unfinished(const Dataset& dataset, const std::string& path) {
  const File file(checked(H5Iget_file_id(dataset.get()), path));
  unsigned intent = 0;
  checked(H5Fget_intent(file.get(), &intent), path);
  return (intent & H5F_ACC_SWMR_READ) != 0;
}

/// How numbers are read. A writer that grows a chunk writes all of it again: killed meanwhile it leaves one
/// whose checksum does not fit, though the records that were there before are in it unchanged.
Properties transfer(const Dataset& dataset, const std::string& path) {
  Properties properties(checked(H5Pcreate(H5P_DATASET_XFER), path));
  if (is_unfinished(dataset, path)) {
    checked(H5Pset_edc_check(properties.get(), H5Z_DISABLE_EDC), path);
  }
  return properties;
}

}  // namespace

std::vector<hsize_t> shape_of(hid_t parent, const std::string& path, int rank) {
  const Dataset dataset = opened(parent, path);
  const Dataspace space(checked(H5Dget_space(dataset.get()), path));
  auto shape = shape_of(space, path);
  if (shape.size() != static_cast<std::size_t>(rank)) {
    throw ArchiveError(ArchiveError::Kind::format, path + " has another shape than an archive's");
  }
  return shape;
}

void read_records(hid_t parent, const std::string& path, hsize_t first, hsize_t count, hid_t type,
                  void* target, std::size_t numbers) {
  const Dataset dataset = opened(parent, path);
  const Dataspace stored(checked(H5Dget_space(dataset.get()), path));
  std::vector<hsize_t> block = shape_of(stored, path);
  if (block.empty() || first + count > block[0]) {
    throw ArchiveError(ArchiveError::Kind::format, path + " is shorter than the archive says");
  }
  std::vector<hsize_t> start(block.size(), 0);
  start[0] = first;
  block[0] = count;
  hsize_t selected = 1;
  for (const hsize_t size : block) selected *= size;
  if (selected != numbers) {
    throw ArchiveError(ArchiveError::Kind::format, path + " has another shape than the archive says");
  }
  checked(H5Sselect_hyperslab(stored.get(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr),
          path);
  const Dataspace memory(
      checked(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), path));
  checked(H5Dread(dataset.get(), type, memory.get(), stored.get(), transfer(dataset, path).get(), target),
          path);
}

}  // namespace rouleau::storage::hdf5
