#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/simulation/output.h"
#include "storage/hdf5/growing_array.h"

namespace rouleau::storage {

/// What a frame says of the cells: `/outlines/cell{k}` with `value` [T][nodes][2] and, for each field that
/// frames carry on the membranes, `NAME` [T][nodes]; `/observables/cell{k}_area` [T], and once
/// `/connectivity/membrane_bonds` [bonds][2], pairs of particle ids. NaN for a cell that has left.
class OutlineWriter {
 public:
  OutlineWriter(hid_t file, const std::vector<int>& nodes_per_cell, const std::vector<MembraneField>& fields);

  void add(const Frame& frame);

 private:
  void add_fields(const Frame& frame, std::size_t cell, std::size_t first_node, std::size_t nodes);
  void write_bonds(const Frame& frame);

  std::vector<int> nodes_per_cell_;
  std::vector<hdf5::GrowingArray> outlines_;
  std::vector<std::vector<hdf5::GrowingArray>> fields_;  ///< [cells][fields]
  std::vector<hdf5::GrowingArray> areas_;
  hdf5::Dataset bonds_;
  bool bonds_written_ = false;
};

}  // namespace rouleau::storage
