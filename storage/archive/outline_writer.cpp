#include "storage/archive/outline_writer.h"

#include <algorithm>
#include <limits>

#include "storage/archive/timed_group.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

using hdf5::checked;
using hdf5::GrowingArray;

constexpr hsize_t times_per_chunk = 1024;

/// Positive counter-clockwise. Summed about the first node, for far from the origin the products would
/// cancel.
double enclosed_area(const std::vector<float>& xy) {
  const std::size_t n = xy.size() / 2;
  const double x0 = xy[0], y0 = xy[1];
  double twice = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    twice += (xy[2 * i] - x0) * (xy[2 * j + 1] - y0) - (xy[2 * j] - x0) * (xy[2 * i + 1] - y0);
  }
  return twice / 2;
}

hdf5::Dataset make_bonds(hid_t file, hsize_t count) {
  const hdf5::Group group = make_group(file, "/connectivity");
  const hsize_t shape[2] = {count, 2};
  const hdf5::Dataspace space(checked(H5Screate_simple(2, shape, nullptr), "bonds"));
  const hdf5::Properties creation(checked(H5Pcreate(H5P_DATASET_CREATE), "bonds"));
  const std::int64_t none = -1;
  checked(H5Pset_fill_value(creation.get(), H5T_NATIVE_INT64, &none), "bonds");
  hdf5::Dataset bonds(checked(H5Dcreate2(group.get(), "membrane_bonds", H5T_STD_I64LE, space.get(),
                                         H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                              "bonds"));
  hobj_ref_t particles{};
  checked(H5Rcreate(&particles, file, "/particles/trajectory", H5R_OBJECT, -1), "bonds");
  const hdf5::Dataspace scalar(checked(H5Screate(H5S_SCALAR), "bonds"));
  const hdf5::Attribute group_of(checked(
      H5Acreate2(bonds.get(), "particles_group", H5T_STD_REF_OBJ, scalar.get(), H5P_DEFAULT, H5P_DEFAULT),
      "bonds"));
  checked(H5Awrite(group_of.get(), H5T_STD_REF_OBJ, &particles), "bonds");
  return bonds;
}

}  // namespace

OutlineWriter::OutlineWriter(hid_t file, const std::vector<int>& nodes_per_cell,
                             const std::vector<MembraneField>& fields)
    : nodes_per_cell_(nodes_per_cell) {
  if (nodes_per_cell.empty()) return;
  const hdf5::Group all = make_group(file, "/outlines");
  if (!fields.empty()) {
    std::vector<std::string> names;
    for (const MembraneField& field : fields) names.push_back(field.name);
    hdf5::write_attribute(all.get(), "fields", names);
  }
  make_group(file, "/observables");
  hsize_t bonds = 0;
  for (std::size_t k = 0; k < nodes_per_cell.size(); ++k) {
    const auto nodes = static_cast<hsize_t>(nodes_per_cell[k]);
    const std::string cell = "cell" + std::to_string(k);
    const hdf5::Group outline = make_timed_group(file, "/outlines/" + cell);
    outlines_.push_back(GrowingArray::create<float>(outline.get(), "value",
                                                    {.record = {nodes, 2}, .chunk = 1, .compressed = true}));
    auto& of_cell = fields_.emplace_back();
    for (const MembraneField& field : fields) {
      of_cell.push_back(GrowingArray::create<float>(outline.get(), field.name,
                                                    {.record = {nodes}, .chunk = 1, .compressed = true}));
      hdf5::write_attribute(of_cell.back().id(), "unit", field.unit);
    }
    const hdf5::Group area = make_timed_group(file, "/observables/" + cell + "_area");
    areas_.push_back(GrowingArray::create<double>(area.get(), "value", {.chunk = times_per_chunk}));
    bonds += nodes;
  }
  bonds_ = make_bonds(file, bonds);
}

void OutlineWriter::add(const Frame& frame) {
  std::size_t i = 0;
  for (std::size_t k = 0; k < outlines_.size(); ++k) {
    const std::size_t numbers = 2 * static_cast<std::size_t>(nodes_per_cell_[k]);
    const std::size_t first_node = i;
    std::vector<float> xy;
    for (; i < frame.id.size() && frame.kind[i] == ParticleKind::membrane &&
           frame.cell[i] == static_cast<std::int32_t>(k);
         ++i) {
      xy.push_back(frame.x[i]);
      xy.push_back(frame.y[i]);
    }
    const bool left = xy.empty();
    if (left) xy.assign(numbers, std::numeric_limits<float>::quiet_NaN());
    if (xy.size() != numbers) {
      throw ArchiveError(ArchiveError::Kind::misuse,
                         "cell " + std::to_string(k) + " has not the membrane nodes that the run announced");
    }
    add_fields(frame, k, first_node, i - first_node);
    outlines_[k].append(std::span<const float>(xy));
    areas_[k].append_one(enclosed_area(xy));
  }
  if (!bonds_written_ && !outlines_.empty()) write_bonds(frame);
}

void OutlineWriter::add_fields(const Frame& frame, std::size_t cell, std::size_t first_node,
                               std::size_t nodes) {
  std::vector<hdf5::GrowingArray>& fields = fields_[cell];
  if (frame.membrane_fields.size() != fields.size()) {
    throw ArchiveError(ArchiveError::Kind::misuse,
                       "a frame carries other fields of the membranes than the run announced");
  }
  for (std::size_t f = 0; f < fields.size(); ++f) {
    std::vector<float> values(static_cast<std::size_t>(nodes_per_cell_[cell]),
                              std::numeric_limits<float>::quiet_NaN());
    const std::vector<float>& all = frame.membrane_fields[f];
    if (all.size() < first_node + nodes) {
      throw ArchiveError(ArchiveError::Kind::misuse, "a field of the membranes lacks nodes");
    }
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first_node), nodes, values.begin());
    fields[f].append(std::span<const float>(values));
  }
}

void OutlineWriter::write_bonds(const Frame& frame) {
  std::vector<std::int64_t> pairs;
  std::size_t first = 0;
  for (const int count : nodes_per_cell_) {
    const auto nodes = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < nodes; ++i) {
      pairs.push_back(frame.id[first + i]);
      pairs.push_back(frame.id[first + (i + 1) % nodes]);
    }
    first += nodes;
  }
  checked(H5Dwrite(bonds_.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, pairs.data()), "bonds");
  bonds_written_ = true;
}

}  // namespace rouleau::storage
