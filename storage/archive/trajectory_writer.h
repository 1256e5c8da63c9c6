#pragma once

#include <optional>
#include <vector>

#include "engine/simulation/output.h"
#include "storage/archive/particle_slots.h"
#include "storage/hdf5/growing_array.h"

namespace rouleau::storage {

/// `/particles/trajectory` as H5MD 1.1 has it: arrays [T][capacity], a particle in one slot for its life;
/// velocity and pressure if `output.fields` names them.
/// Slots without a particle have `alive` 0, `id` and `cell` -1, and stand still in the middle of the vessel,
/// where they stretch no reader's picture.
class TrajectoryWriter {
 public:
  TrajectoryWriter(hid_t file, const RunHeader& header);

  /// Appends the frame, its step and time too.
  void add(const Frame& frame);

 private:
  void clear_slots();

  std::size_t capacity_;
  float park_x_, park_y_;
  ParticleSlots slots_;
  bool with_velocity_, with_pressure_;
  std::vector<hdf5::GrowingArray> arrays_;  // in the order of `Array` in the .cpp
  std::optional<hdf5::GrowingArray> velocities_, pressures_;
  std::vector<float> position_, velocity_, pressure_;
  std::vector<std::uint8_t> species_, alive_;
  std::vector<std::int64_t> id_;
  std::vector<std::int32_t> cell_;
};

}  // namespace rouleau::storage
