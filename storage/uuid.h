#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "storage/job.h"

namespace rouleau::storage {

/// UUIDs of version 7 (RFC 9562): 48 bits of milliseconds, then random bits. Each is greater than the one
/// before, also within a millisecond and when the clock steps back. Not thread-safe.
class UuidSource {
 public:
  std::string next(TimeMs now);

  /// What comes next is greater than `id`, too. Text that is no UUID is passed over.
  void start_after(std::string_view id);

 private:
  std::uint64_t time_ = 0;  // 48 bits
  std::uint16_t high_ = 0;  // 12 bits, `rand_a`
  std::uint64_t low_ = 0;   // 62 bits, `rand_b`
};

bool is_uuid(std::string_view text);

}  // namespace rouleau::storage
