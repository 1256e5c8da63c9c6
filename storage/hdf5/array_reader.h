#pragma once

#include <string>
#include <vector>

#include <hdf5.h>

#include "storage/hdf5/native_type.h"

namespace rouleau::storage::hdf5 {

/// The shape of a dataset; @throws ArchiveError unless it has `rank` dimensions and a believable size.
std::vector<hsize_t> shape_of(hid_t parent, const std::string& path, int rank);

/// Reads records [first, first + count) of a dataset [T][record...] into `target`.
void read_records(hid_t parent, const std::string& path, hsize_t first, hsize_t count, hid_t type,
                  void* target, std::size_t numbers);

/// Record k of a dataset with `numbers` numbers a record.
template <class Number>
std::vector<Number> read_record(hid_t parent, const std::string& path, hsize_t k, std::size_t numbers) {
  std::vector<Number> values(numbers);
  read_records(parent, path, k, 1, native_type<Number>(), values.data(), numbers);
  return values;
}

/// All of a dataset [T].
template <class Number>
std::vector<Number> read_column(hid_t parent, const std::string& path) {
  const hsize_t count = shape_of(parent, path, 1)[0];
  std::vector<Number> values(count);
  if (count > 0) read_records(parent, path, 0, count, native_type<Number>(), values.data(), count);
  return values;
}

}  // namespace rouleau::storage::hdf5
