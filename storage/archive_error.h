#pragma once

#include <stdexcept>
#include <string>

namespace rouleau::storage {

/// An archive that could not be written or read.
class ArchiveError : public std::runtime_error {
 public:
  enum class Kind {
    disk_full,
    io,      ///< the file system refused, or there is no such file
    format,  ///< not an archive of ours, or a damaged one
    range,   ///< a frame, cell or column that the archive does not have
    misuse,  ///< calls out of order, a row or frame that does not fit the header
  };

  ArchiveError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace rouleau::storage
