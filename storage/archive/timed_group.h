#pragma once

#include <string>

#include "storage/hdf5/handle.h"

namespace rouleau::storage {

/// The `step` and `time` that everything of one cadence shares: H5MD wants them beside each `value`, and hard
/// links to the first ones keep them in lock-step.
inline constexpr const char* step_path = "/particles/trajectory/position/step";
inline constexpr const char* time_path = "/particles/trajectory/position/time";

/// Makes group `name`, which holds those links and waits for its `value`.
hdf5::Group make_timed_group(hid_t file, const std::string& path);

hdf5::Group make_group(hid_t parent, const std::string& path);

}  // namespace rouleau::storage
