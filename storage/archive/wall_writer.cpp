#include "storage/archive/wall_writer.h"

#include "storage/archive/timed_group.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

using hdf5::GrowingArray;

WallWriter::WallWriter(hid_t file, const WallNodes& walls) : nodes_(walls.x.size()) {
  if (nodes_ == 0) return;
  const hdf5::Group group = make_group(file, "/walls");
  write_fixed(group.get(), "x", walls.x);
  write_fixed(group.get(), "y", walls.y);
  write_fixed(group.get(), "arc_length", walls.arc_length);
  write_fixed(group.get(), "wall", walls.wall);
  std::vector<double> normal;
  for (std::size_t i = 0; i < nodes_; ++i) normal.insert(normal.end(), {walls.nx[i], walls.ny[i]});
  auto normals = GrowingArray::create<double>(group.get(), "normal", {.record = {2}, .chunk = nodes_});
  normals.append(std::span<const double>(normal));
  link_frame_times(file, group.get());
  stress_ = GrowingArray::create<float>(group.get(), "shear_stress",
                                        {.record = {nodes_}, .chunk = 1, .compressed = true});
  hdf5::write_attribute(stress_->id(), "unit", std::string("Pa"));
}

void WallWriter::add(const Frame& frame) {
  if (frame.wall_shear_stress.size() != nodes_) {
    throw ArchiveError(ArchiveError::Kind::misuse, "a frame has other wall nodes than the run announced");
  }
  if (stress_) stress_->append(std::span<const float>(frame.wall_shear_stress));
}

}  // namespace rouleau::storage
