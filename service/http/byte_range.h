#pragma once

#include <cstdint>
#include <string_view>

namespace rouleau::service {

/// What part of `size` bytes a Range header asks for, clamped to what there is.
struct ByteRange {
  enum class Kind {
    whole,          ///< no range, one that is not understood, or several: the whole is sent
    part,           ///< first..last
    unsatisfiable,  ///< begins past the end
  };
  Kind kind = Kind::whole;
  std::uint64_t first = 0;
  std::uint64_t last = 0;  ///< inclusive

  std::uint64_t length() const { return last - first + 1; }
};

/// RFC 9110, section 14: a range of another unit or a malformed one is ignored. Several ranges are answered
/// with the whole, as a server may.
ByteRange parse_byte_range(std::string_view header, std::uint64_t size);

}  // namespace rouleau::service
