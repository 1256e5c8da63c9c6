#include "storage/archive/replay.h"

#include <algorithm>

#include "storage/archive.h"
#include "storage/archive/opened.h"
#include "storage/hdf5/array_reader.h"

namespace rouleau::storage {

namespace {

/// The first rows of a dataset [T][record], however many there are: the last ones may be half written.
std::vector<double> first_rows(hid_t file, const std::string& path, hsize_t rows, std::size_t record) {
  std::vector<double> values(rows * record);
  if (!values.empty()) {
    hdf5::read_records(file, path, 0, rows, hdf5::native_type<double>(), values.data(), values.size());
  }
  return values;
}

struct RecordedProbe {
  std::size_t points;
  std::vector<double> u, v, p, flux;

  ProbeValues at(std::size_t row) const {
    const auto part = [&](const std::vector<double>& values) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * points);
      return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(points));
    };
    return {part(u), part(v), part(p), flux.empty() ? 0 : flux[row]};
  }
};

/// Rows of the series and of the probes.
struct RecordedRows {
  std::vector<std::vector<double>> columns;
  std::vector<RecordedProbe> probes;

  std::vector<double> row(std::size_t k) const {
    std::vector<double> values;
    for (const auto& column : columns) values.push_back(column[k]);
    return values;
  }
  std::vector<ProbeValues> probe_row(std::size_t k) const {
    std::vector<ProbeValues> values;
    for (const RecordedProbe& probe : probes) values.push_back(probe.at(k));
    return values;
  }
};

RecordedRows read_rows(const std::filesystem::path& archive, hsize_t rows) {
  const ArchiveReader reader(archive);
  const auto columns = reader.columns();
  const auto probes = reader.probe_names();
  return opened(archive, [&](hid_t file) {
    RecordedRows read;
    for (const Column& column : columns) {
      read.columns.push_back(first_rows(file, "/series/" + column.name, rows, 1));
    }
    for (const std::string& name : probes) {
      const std::string at = "/probes/" + name + "/";
      const std::size_t points = hdf5::shape_of(file, at + "x", 1)[0];
      RecordedProbe& probe = read.probes.emplace_back();
      probe.points = points;
      probe.u = first_rows(file, at + "u", rows, points);
      probe.v = first_rows(file, at + "v", rows, points);
      probe.p = first_rows(file, at + "p", rows, points);
      if (H5Lexists(file, (at + "flux").c_str(), H5P_DEFAULT) > 0) {
        probe.flux = first_rows(file, at + "flux", rows, 1);
      }
    }
    return read;
  });
}

}  // namespace

bool can_replay(const std::filesystem::path& archive, const CheckpointHead& head) {
  if (ArchiveReader(archive).frame_count() < head.frames) return false;
  try {
    read_rows(archive, static_cast<hsize_t>(head.rows));
    return true;
  } catch (const ArchiveError&) {
    return false;
  }
}

void replay(const std::filesystem::path& archive, const CheckpointHead& head, Output& output) {
  const ArchiveReader reader(archive);
  const RecordedRows recorded = read_rows(archive, static_cast<hsize_t>(head.rows));
  const auto rows = static_cast<std::size_t>(head.rows);
  std::size_t row = 0;
  const auto rows_until = [&](double time) {
    for (; row < rows && recorded.columns.front()[row] <= time; ++row) {
      output.series_row(recorded.row(row));
      if (!recorded.probes.empty()) output.probe_row(recorded.columns.front()[row], recorded.probe_row(row));
    }
  };
  for (int k = 0; k < head.frames; ++k) {
    const Frame frame = reader.frame(k);
    rows_until(frame.time);
    output.frame(frame);
  }
  rows_until(head.simulated_time);
}

}  // namespace rouleau::storage
