#pragma once

#include <span>
#include <string>
#include <vector>

#include <hdf5.h>

#include "storage/hdf5/handle.h"
#include "storage/hdf5/native_type.h"
#include "storage/hdf5/session.h"

namespace rouleau::storage::hdf5 {

/// A dataset [T][record...] of one kind of number that grows along T.
class GrowingArray {
 public:
  struct Layout {
    std::vector<hsize_t> record{};  ///< shape of one record; empty: a number
    hsize_t chunk = 1;              ///< records a chunk
    bool compressed = false;
  };

  template <class Number>
  static GrowingArray create(hid_t parent, const std::string& name, const Layout& layout, Number fill = 0) {
    return GrowingArray(parent, name, layout, stored_type<Number>(), native_type<Number>(), &fill);
  }

  /// Appends whole records: their numbers one after the other.
  template <class Number>
  void append(std::span<const Number> numbers) {
    append(numbers.data(), numbers.size(), native_type<Number>());
  }
  template <class Number>
  void append_one(Number number) {
    append(&number, 1, native_type<Number>());
  }

  hid_t id() const { return dataset_.get(); }

 private:
  GrowingArray(hid_t parent, const std::string& name, const Layout& layout, hid_t stored, hid_t native,
               const void* fill);
  void append(const void* numbers, std::size_t count, hid_t type);

  std::string name_;
  Dataset dataset_;
  std::vector<hsize_t> extent_;  // [T, record...] now
  hsize_t numbers_per_record_ = 1;
};

}  // namespace rouleau::storage::hdf5
