#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/simulation/output.h"
#include "storage/archive_error.h"

namespace rouleau::storage {

/// Columns of the time series; `values[c][row]`.
struct SeriesTable {
  std::vector<Column> columns;
  std::vector<std::vector<double>> values;
};

/// What a probe saw. u, v and p are [T][points] one row after the other, NaN outside the fluid.
struct ProbeTable {
  std::vector<double> x, y;     ///< [points] m
  std::vector<double> time;     ///< [T] s
  std::vector<double> u, v, p;  ///< m/s, m/s, Pa
  std::vector<double> flux;     ///< [T] m2/s; none of a single point
};

/// The closed outline of a cell at one instant, counter-clockwise; empty once it has left the vessel.
struct Outline {
  std::vector<float> x, y;                           ///< m
  std::map<std::string, std::vector<float>> fields;  ///< by name, those that frames carry on the membranes
};

/// Reads archives of ours. The file is open only while a call lasts, so a reader never stands in the way of a
/// writer in the same process. Each call may throw ArchiveError.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::filesystem::path path);

  /// The columns of the series in their order, without their values.
  std::vector<Column> columns() const;
  /// The columns named, in that order; none named: all of them.
  SeriesTable series(const std::vector<std::string>& names = {}) const;

  std::vector<std::string> probe_names() const;
  ProbeTable probe(const std::string& name) const;

  int frame_count() const;
  std::vector<double> frame_times() const;  ///< s
  /// The particles alive in frame k, membrane nodes first as the run gave them, and the stress on the walls;
  /// fields that the run did not keep are empty.
  Frame frame(int k) const;
  /// Where the stress on the walls is sampled; none if the run did not keep it.
  WallNodes walls() const;
  /// Of every cell in frame k.
  std::vector<Outline> outlines(int k) const;

  std::string case_given() const;
  nlohmann::json case_resolved() const;
  nlohmann::json plan() const;
  std::string version() const;  ///< of the engine that wrote it
  /// How the run ended, as `to_json(RunSummary)` has it; null while it is being written.
  nlohmann::json summary() const;

 private:
  std::filesystem::path path_;
};

}  // namespace rouleau::storage
