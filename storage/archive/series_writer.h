#pragma once

#include <span>
#include <vector>

#include "engine/simulation/output.h"
#include "storage/hdf5/growing_array.h"

namespace rouleau::storage {

/// `/series`: a dataset [rows] a column, its unit beside it, and the order of the columns.
class SeriesWriter {
 public:
  SeriesWriter(hid_t file, const std::vector<Column>& columns);

  void add(std::span<const double> row);
  /// Rows are gathered and go to the file with the next frame, or when there are many.
  void write_gathered();

 private:
  std::vector<hdf5::GrowingArray> columns_;
  std::vector<std::vector<double>> gathered_;
};

}  // namespace rouleau::storage
