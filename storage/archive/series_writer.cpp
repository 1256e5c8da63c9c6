#include "storage/archive/series_writer.h"

#include <string>

#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

constexpr hsize_t rows_per_chunk = 1024;

}  // namespace

SeriesWriter::SeriesWriter(hid_t file, const std::vector<Column>& columns) : gathered_(columns.size()) {
  const hdf5::Group group(
      hdf5::checked(H5Gcreate2(file, "series", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "series"));
  std::vector<std::string> names;
  for (const Column& column : columns) {
    // Not compressed: a chunk that grows with every frame would leave its earlier, smaller self behind.
    columns_.push_back(
        hdf5::GrowingArray::create<double>(group.get(), column.name, {.chunk = rows_per_chunk}));
    hdf5::write_attribute(columns_.back().id(), "unit", column.unit);
    names.push_back(column.name);
  }
  hdf5::write_attribute(group.get(), "columns", names);
}

void SeriesWriter::add(std::span<const double> row) {
  if (row.size() != columns_.size()) {
    throw ArchiveError(ArchiveError::Kind::misuse, "a series row of " + std::to_string(row.size()) +
                                                       " values for " + std::to_string(columns_.size()) +
                                                       " columns");
  }
  for (std::size_t c = 0; c < row.size(); ++c) gathered_[c].push_back(row[c]);
  if (!gathered_.empty() && gathered_.front().size() >= rows_per_chunk) write_gathered();
}

void SeriesWriter::write_gathered() {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    columns_[c].append(std::span<const double>(gathered_[c]));
    gathered_[c].clear();
  }
}

}  // namespace rouleau::storage
