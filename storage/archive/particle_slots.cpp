#include "storage/archive/particle_slots.h"

#include <algorithm>
#include <functional>

#include "storage/archive_error.h"

namespace rouleau::storage {

ParticleSlots::ParticleSlots(int capacity) {
  for (int slot = capacity - 1; slot >= 0; --slot) free_.push_back(slot);
}

const std::vector<int>& ParticleSlots::assign(std::span<const std::int64_t> ids) {
  ++frame_;
  for (const std::int64_t id : ids) {
    const auto known = places_.find(id);
    if (known != places_.end()) known->second.frame = frame_;
  }
  const auto left = std::erase_if(places_, [&](const auto& entry) {
    if (entry.second.frame == frame_) return false;
    free_.push_back(entry.second.slot);
    return true;
  });
  if (left > 0) std::sort(free_.begin(), free_.end(), std::greater<>());

  slots_.clear();
  for (const std::int64_t id : ids) {
    const auto [place, is_new] = places_.try_emplace(id, Place{0, frame_});
    if (is_new) {
      if (free_.empty()) {
        throw ArchiveError(ArchiveError::Kind::misuse, "a frame has more particles than the run announced");
      }
      place->second.slot = free_.back();
      free_.pop_back();
    }
    slots_.push_back(place->second.slot);
  }
  if (places_.size() != ids.size()) {
    throw ArchiveError(ArchiveError::Kind::misuse, "two particles of a frame have one id");
  }
  return slots_;
}

}  // namespace rouleau::storage
