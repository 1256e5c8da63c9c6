#include "storage/archive/trajectory_writer.h"

#include <algorithm>
#include <string>

#include "storage/archive/timed_group.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

using hdf5::GrowingArray;

enum Array { step, time, position, species, id, alive, cell };

constexpr hsize_t times_per_chunk = 1024;
constexpr const char* trajectory = "/particles/trajectory";

template <class Number>
GrowingArray element(hid_t file, const std::string& name, std::vector<hsize_t> record, Number fill = 0) {
  const hdf5::Group group = make_timed_group(file, std::string(trajectory) + "/" + name);
  return GrowingArray::create<Number>(group.get(), "value",
                                      {.record = std::move(record), .chunk = 1, .compressed = true}, fill);
}

void write_box(hid_t file) {
  const hdf5::Group box = make_group(file, std::string(trajectory) + "/box");
  hdf5::write_attribute(box.get(), "dimension", 3);
  hdf5::write_attribute(box.get(), "boundary", std::vector<std::string>(3, "none"));
}

/// Whether a frame's arrays have one entry a particle, and those it should not have none.
bool has_right_sizes(const Frame& frame, bool with_velocity, bool with_pressure) {
  const std::size_t n = frame.id.size();
  const std::size_t velocities = with_velocity ? n : 0;
  return frame.kind.size() == n && frame.cell.size() == n && frame.x.size() == n && frame.y.size() == n &&
         frame.u.size() == velocities && frame.v.size() == velocities &&
         frame.p.size() == (with_pressure ? n : 0);
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(hid_t file, const RunHeader& header)
    : capacity_(static_cast<std::size_t>(std::max(header.capacity, 1))),
      park_x_(static_cast<float>(header.resolved.vessel.length / 2)),
      park_y_(static_cast<float>(header.resolved.vessel.diameter / 2)),
      slots_(static_cast<int>(capacity_)),
      with_velocity_(carries(header.resolved, Field::velocity)),
      with_pressure_(carries(header.resolved, Field::pressure)),
      position_(3 * capacity_),
      velocity_(3 * capacity_),
      pressure_(capacity_),
      species_(capacity_),
      alive_(capacity_),
      id_(capacity_),
      cell_(capacity_) {
  make_group(file, "/particles");
  make_group(file, trajectory);
  write_box(file);
  const hsize_t n = capacity_;
  const hdf5::Group first = make_group(file, std::string(trajectory) + "/position");
  arrays_.push_back(GrowingArray::create<std::int64_t>(first.get(), "step", {.chunk = times_per_chunk}));
  arrays_.push_back(GrowingArray::create<double>(first.get(), "time", {.chunk = times_per_chunk}));
  arrays_.push_back(
      GrowingArray::create<float>(first.get(), "value", {.record = {n, 3}, .chunk = 1, .compressed = true}));
  if (with_velocity_) velocities_ = element<float>(file, "velocity", {n, 3});
  if (with_pressure_) pressures_ = element<float>(file, "pressure", {n});
  arrays_.push_back(element<std::uint8_t>(file, "species", {n}));
  arrays_.push_back(element<std::int64_t>(file, "id", {n}, -1));
  arrays_.push_back(element<std::uint8_t>(file, "alive", {n}));
  arrays_.push_back(element<std::int32_t>(file, "cell", {n}, -1));
}

void TrajectoryWriter::clear_slots() {
  for (std::size_t slot = 0; slot < capacity_; ++slot) {
    position_[3 * slot] = park_x_;
    position_[3 * slot + 1] = park_y_;
  }
  std::fill(velocity_.begin(), velocity_.end(), 0.0f);
  std::fill(pressure_.begin(), pressure_.end(), 0.0f);
  std::fill(species_.begin(), species_.end(), std::uint8_t{0});
  std::fill(alive_.begin(), alive_.end(), std::uint8_t{0});
  std::fill(id_.begin(), id_.end(), std::int64_t{-1});
  std::fill(cell_.begin(), cell_.end(), -1);
}

void TrajectoryWriter::add(const Frame& frame) {
  if (!has_right_sizes(frame, with_velocity_, with_pressure_)) {
    throw ArchiveError(ArchiveError::Kind::misuse, "a frame's arrays differ in size");
  }
  const std::vector<int>& slots = slots_.assign(frame.id);
  clear_slots();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto slot = static_cast<std::size_t>(slots[i]);
    position_[3 * slot] = frame.x[i];
    position_[3 * slot + 1] = frame.y[i];
    if (with_velocity_) velocity_[3 * slot] = frame.u[i];
    if (with_velocity_) velocity_[3 * slot + 1] = frame.v[i];
    if (with_pressure_) pressure_[slot] = frame.p[i];
    species_[slot] = static_cast<std::uint8_t>(frame.kind[i]);
    alive_[slot] = 1;
    id_[slot] = frame.id[i];
    cell_[slot] = frame.cell[i];
  }
  arrays_[position].append(std::span<const float>(position_));
  if (velocities_) velocities_->append(std::span<const float>(velocity_));
  if (pressures_) pressures_->append(std::span<const float>(pressure_));
  arrays_[species].append(std::span<const std::uint8_t>(species_));
  arrays_[alive].append(std::span<const std::uint8_t>(alive_));
  arrays_[id].append(std::span<const std::int64_t>(id_));
  arrays_[cell].append(std::span<const std::int32_t>(cell_));
  arrays_[step].append_one(static_cast<std::int64_t>(frame.step));
  arrays_[time].append_one(frame.time);
}

}  // namespace rouleau::storage
