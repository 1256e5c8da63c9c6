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
  bool csv = false;
};

void print_table(const storage::SeriesTable& table) {
  for (const Column& column : table.columns) std::cout << fmt::format("{:>16}", column.name);
  std::cout << '\n';
  const std::size_t rows = table.values.empty() ? 0 : table.values.front().size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (const auto& values : table.values) std::cout << fmt::format("{:16.6g}", values[r]);
    std::cout << '\n';
  }
}

int series(const Options& options, bool json) {
  storage::SeriesTable table;
  try {
    table = storage::ArchiveReader(options.archive).series(split_list(options.columns));
  } catch (const storage::ArchiveError& error) {
    throw CommandError(exit_bad_input, error.what());
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
  auto* const csv = command->add_flag("--csv", options->csv, "As CSV with one header line");
  command->add_flag("--json", action.json, "As JSON")->excludes(csv);
  command->callback(
      [&action, options] { action.run = [&action, options] { return series(*options, action.json); }; });
}

}  // namespace rouleau::service
