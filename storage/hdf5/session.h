#pragma once

#include <mutex>
#include <string>

#include <hdf5.h>

#include "storage/archive_error.h"

namespace rouleau::storage::hdf5 {

/// Held around each whole sequence of HDF5 calls. The library's own lock covers single calls only, and its
/// objects are shared between threads behind our back (a file opened twice is one file inside).
class Session {
 public:
  Session();

 private:
  std::lock_guard<std::mutex> lock_;
};

/// The error that HDF5 has just reported to this thread.
ArchiveError last_error(const std::string& what);

/// The value of an HDF5 call; @throws ArchiveError if it is negative, as HDF5 reports failure.
template <class Value>
Value checked(Value value, const std::string& what) {
  if (value < 0) throw last_error(what);
  return value;
}

}  // namespace rouleau::storage::hdf5
