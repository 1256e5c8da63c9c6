#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "storage/hdf5/growing_array.h"
#include "storage/hdf5/handle.h"

namespace rouleau::storage {

/// The `step` and `time` that everything of one cadence shares: H5MD wants them beside each `value`, and hard
/// links to the first ones keep them in lock-step.
inline constexpr const char* step_path = "/particles/trajectory/position/step";
inline constexpr const char* time_path = "/particles/trajectory/position/time";

/// Makes group `name`, which holds those links and waits for its `value`.
hdf5::Group make_timed_group(hid_t file, const std::string& path);

/// Gives a group the link to the frames' times alone.
void link_frame_times(hid_t file, hid_t group);

hdf5::Group make_group(hid_t parent, const std::string& path);

/// A dataset [n] that is written once.
template <class Number>
void write_fixed(hid_t group, const std::string& name, const std::vector<Number>& numbers) {
  const auto count = std::max<hsize_t>(numbers.size(), 1);
  hdf5::GrowingArray::create<Number>(group, name, {.chunk = count}).append(std::span<const Number>(numbers));
}

}  // namespace rouleau::storage
