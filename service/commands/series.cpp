#include <cmath>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/api/query.h"
#include "service/api/series_table.h"
#include "service/commands/command.h"
#include "service/http/problem.h"
#include "storage/archive_reader.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string archive;
  std::string columns;
  std::string probe;
  bool csv = false;
};

void print_table(const storage::SeriesTable& table) {
  for (const Column& column : table.columns) std::cout << fmt::format("{:>16}", column.name);
  std::cout << '\n';
  const std::size_t rows = table.values.empty() ? 0 : table.values.front().size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (const auto& values : table.values) {
      std::cout << (std::isfinite(values[r]) ? fmt::format("{:16.6g}", values[r])
                                             : fmt::format("{:>16}", "-"));
    }
    std::cout << '\n';
  }
}

/// A probe's values as a table with a row for each time and point.
storage::SeriesTable probe_table(const storage::ProbeTable& probe) {
  storage::SeriesTable table;
  table.columns = {{"time", "s"}, {"x", "m"}, {"y", "m"}, {"u", "m/s"}, {"v", "m/s"}, {"p", "Pa"}};
  if (!probe.flux.empty()) table.columns.push_back({"flux", "m2/s"});
  table.values.resize(table.columns.size());
  const std::size_t points = probe.x.size();
  for (std::size_t t = 0; t < probe.time.size(); ++t) {
    for (std::size_t k = 0; k < points; ++k) {
      const std::size_t i = t * points + k;
      const double row[] = {probe.time[t], probe.x[k], probe.y[k], probe.u[i], probe.v[i], probe.p[i]};
      for (std::size_t c = 0; c < std::size(row); ++c) table.values[c].push_back(row[c]);
      if (!probe.flux.empty()) table.values.back().push_back(probe.flux[t]);
    }
  }
  return table;
}

storage::SeriesTable read_table(const Options& options) {
  const storage::ArchiveReader archive(options.archive);
  const auto columns = split_list(options.columns);
  return options.probe.empty() ? archive.series(columns)
                               : select_columns(probe_table(archive.probe(options.probe)), columns);
}

int series(const Options& options, bool json) {
  storage::SeriesTable table;
  try {
    table = read_table(options);
  } catch (const storage::ArchiveError& error) {
    throw CommandError(exit_bad_input, error.what());
  } catch (const Problem& problem) {
    throw CommandError(exit_bad_input, problem.faults().front().message);
  }
  if (json) {
    std::cout << dump(series_json(table)) << '\n';
  } else if (options.csv) {
    std::cout << series_csv(table);
  } else {
    print_table(table);
  }
  return exit_done;
}

}  // namespace

void add_series(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("series", "Print the time series of an archive");
  const auto options = std::make_shared<Options>();
  command->add_option("OUT.h5", options->archive, "The archive")->required();
  command->add_option("--columns", options->columns, "These columns alone, such as time,cell0.u,cell0.tau");
  command->add_option("--probe", options->probe, "A probe's values, a row for each time and point");
  auto* const csv = command->add_flag("--csv", options->csv, "As CSV with one header line");
  command->add_flag("--json", action.json, "As JSON")->excludes(csv);
  command->callback(
      [&action, options] { action.run = [&action, options] { return series(*options, action.json); }; });
}

}  // namespace rouleau::service
