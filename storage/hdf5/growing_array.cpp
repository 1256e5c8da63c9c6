#include "storage/hdf5/growing_array.h"

namespace rouleau::storage::hdf5 {

GrowingArray::GrowingArray(hid_t parent, const std::string& name, const Layout& layout, hid_t stored,
                           hid_t native, const void* fill)
    : name_(name), extent_{0} {
  std::vector<hsize_t> limit{H5S_UNLIMITED};
  std::vector<hsize_t> chunk{layout.chunk};
  for (const hsize_t size : layout.record) {
    extent_.push_back(size);
    limit.push_back(size);
    chunk.push_back(size);
    numbers_per_record_ *= size;
  }
  const int rank = static_cast<int>(extent_.size());
  const Dataspace space(checked(H5Screate_simple(rank, extent_.data(), limit.data()), name));
  const Properties creation(checked(H5Pcreate(H5P_DATASET_CREATE), name));
  checked(H5Pset_chunk(creation.get(), rank, chunk.data()), name);
  checked(H5Pset_fill_value(creation.get(), native, fill), name);
  if (layout.compressed) {
    checked(H5Pset_shuffle(creation.get()), name);
    checked(H5Pset_deflate(creation.get(), 1), name);
  }
  // The metadata of this file format has checksums, numbers have them only so: a disk that rots is noticed.
  checked(H5Pset_fletcher32(creation.get()), name);
  dataset_ = Dataset(checked(
      H5Dcreate2(parent, name.c_str(), stored, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), name));
}

void GrowingArray::append(const void* numbers, std::size_t count, hid_t type) {
  if (count == 0) return;
  if (count % numbers_per_record_ != 0) {
    throw ArchiveError(ArchiveError::Kind::misuse, name_ + ": not a whole number of records");
  }
  std::vector<hsize_t> start(extent_.size(), 0);
  std::vector<hsize_t> block = extent_;
  start[0] = extent_[0];
  block[0] = count / numbers_per_record_;
  extent_[0] += block[0];
  checked(H5Dset_extent(dataset_.get(), extent_.data()), name_);
  const Dataspace target(checked(H5Dget_space(dataset_.get()), name_));
  checked(H5Sselect_hyperslab(target.get(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr),
          name_);
  const int rank = static_cast<int>(block.size());
  const Dataspace source(checked(H5Screate_simple(rank, block.data(), nullptr), name_));
  checked(H5Dwrite(dataset_.get(), type, source.get(), target.get(), H5P_DEFAULT, numbers), name_);
}

}  // namespace rouleau::storage::hdf5
