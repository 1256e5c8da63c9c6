#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace rouleau::storage {

/// Gives every particle one of a fixed number of places, its own while it lives; the places of those that
/// left are given to those that come. The first frame takes its places in its own order, so the membrane,
/// which comes first and stays, keeps it.
class ParticleSlots {
 public:
  explicit ParticleSlots(int capacity);

  /// The slot of each particle of a frame, in the frame's order.
  /// @throws ArchiveError if they are more than the capacity or two have one id
  const std::vector<int>& assign(std::span<const std::int64_t> ids);

 private:
  struct Place {
    int slot = 0;
    long frame = 0;  // the last that it was seen in
  };

  long frame_ = 0;
  std::unordered_map<std::int64_t, Place> places_;
  std::vector<int> free_;  // the lowest last
  std::vector<int> slots_;
};

}  // namespace rouleau::storage
