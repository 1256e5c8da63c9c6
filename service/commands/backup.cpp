#include "storage/backup.h"

#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/commands/command.h"
#include "service/http/problem.h"
#include "service/known_machine.h"

namespace rouleau::service {

namespace {

struct Options {
  std::filesystem::path data;
  std::filesystem::path backup;
  bool links = false;
};

double megabytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) / 1e6;
}

/// Says on standard error what is not in a backup.
void warn_of(const std::vector<std::string>& missing) {
  for (const std::string& name : missing) {
    std::cerr << "warning: " << name << " is gone or damaged; its job is in the backup without it\n";
  }
}

int back_up(const Options& options, bool json) {
  const storage::BackupReport report = storage::back_up(options.data, options.backup, options.links);
  if (json) {
    std::cout << dump({{"jobs", report.jobs},
                       {"files", report.files},
                       {"bytes", report.bytes},
                       {"added", report.added},
                       {"added_bytes", report.added_bytes},
                       {"missing", report.missing}})
              << '\n';
  } else {
    std::cout << fmt::format("{} jobs, {} files of {:.1f} MB in {}; new are {} of {:.1f} MB\n", report.jobs,
                             report.files, megabytes(report.bytes), options.backup.string(), report.added,
                             megabytes(report.added_bytes));
  }
  warn_of(report.missing);
  return report.missing.empty() ? exit_done : exit_failed;
}

int restore(const Options& options, bool json) {
  const storage::RestoreReport report = storage::restore(options.backup, options.data);
  if (json) {
    std::cout << dump({{"jobs", report.jobs},
                       {"files", report.files},
                       {"bytes", report.bytes},
                       {"missing", report.missing}})
              << '\n';
  } else {
    std::cout << fmt::format("{} jobs, {} files of {:.1f} MB in {}\n", report.jobs, report.files,
                             megabytes(report.bytes), options.data.string());
  }
  warn_of(report.missing);
  return exit_done;
}

}  // namespace

void add_backup(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "backup", "Copy a data folder, also while a service works on it; again for what is new");
  const auto options = std::make_shared<Options>();
  options->data = default_data_folder();
  command->add_option("DIR", options->backup, "Where the backup is, or is to be")->required();
  command->add_option("--data", options->data, "The data folder")
      ->envname("ROULEAU_DATA")
      ->capture_default_str();
  command->add_flag(
      "--link", options->links,
      "Let archives be hard links if both are on one file system: quick, but no help if that disk dies");
  command->add_flag("--json", action.json, "Print what was copied as JSON");
  command->footer("Exit codes: 0 done, 1 not all could be copied.");
  command->callback(
      [&action, options] { action.run = [&action, options] { return back_up(*options, action.json); }; });
}

void add_restore(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("restore", "Make a data folder from a backup, every byte of it checked");
  const auto options = std::make_shared<Options>();
  command->add_option("BACKUP", options->backup, "The backup")->required()->check(CLI::ExistingDirectory);
  command->add_option("--data", options->data, "The data folder to be made: new, or empty")->required();
  command->add_flag("--json", action.json, "Print what was restored as JSON");
  command->callback(
      [&action, options] { action.run = [&action, options] { return restore(*options, action.json); }; });
}

}  // namespace rouleau::service
