#pragma once

#include <optional>

#include "engine/simulation/output.h"
#include "storage/hdf5/growing_array.h"

namespace rouleau::storage {

/// `/walls`, if frames carry the stress on them: `x`, `y`, `arc_length`, `wall` [nodes], `normal` [nodes][2],
/// `shear_stress` [T][nodes], and `time` [T], which is the frames'.
class WallWriter {
 public:
  WallWriter(hid_t file, const WallNodes& walls);

  void add(const Frame& frame);

 private:
  std::size_t nodes_;
  std::optional<hdf5::GrowingArray> stress_;
};

}  // namespace rouleau::storage
