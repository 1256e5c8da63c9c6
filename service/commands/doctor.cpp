#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/commands/command.h"
#include "service/http/problem.h"
#include "service/known_machine.h"
#include "storage/checkup.h"
#include "storage/store_error.h"

namespace rouleau::service {

namespace {

struct Options {
  std::filesystem::path data;
  storage::CheckupOptions checkup;
};

nlohmann::json to_json(const storage::Checkup& checkup) {
  nlohmann::json findings = nlohmann::json::array();
  for (const storage::Finding& finding : checkup.findings) {
    findings.push_back({{"kind", storage::to_string(finding.kind)},
                        {"subject", finding.subject},
                        {"message", finding.message},
                        {"mend", finding.mend},
                        {"mended", finding.mended}});
  }
  return {{"healthy", checkup.healthy()},     {"jobs", checkup.jobs},
          {"archives", checkup.archives},     {"archive_bytes", checkup.archive_bytes},
          {"free_bytes", checkup.free_bytes}, {"findings", std::move(findings)}};
}

void print(const storage::Checkup& checkup, bool mending) {
  for (const storage::Finding& finding : checkup.findings) {
    std::cout << fmt::format("{}: {}: {}\n", storage::to_string(finding.kind), finding.subject,
                             finding.message);
    if (finding.mended) {
      std::cout << "  mended: " << finding.mend << '\n';
    } else if (!finding.mend.empty()) {
      std::cout << "  to mend it: " << finding.mend << '\n';
    }
  }
  std::cout << fmt::format("{} jobs, {} archives of {:.1f} MB, {:.1f} GB left on the disk: {}\n",
                           checkup.jobs, checkup.archives, static_cast<double>(checkup.archive_bytes) / 1e6,
                           static_cast<double>(checkup.free_bytes) / 1e9,
                           checkup.healthy() ? "healthy"
                           : mending         ? "not all could be mended"
                                             : "--mend mends what can be mended");
}

int doctor(const Options& options, bool json) {
  storage::Checkup checkup;
  try {
    checkup = storage::check_up(options.data, options.checkup);
  } catch (const storage::StoreError& error) {
    const bool in_use = error.kind() == storage::StoreError::Kind::folder_in_use;
    throw CommandError(exit_bad_input, in_use ? std::string(error.what()) + ": stop it first" : error.what());
  }
  if (json) {
    std::cout << dump(to_json(checkup)) << '\n';
  } else {
    print(checkup, options.checkup.mend);
  }
  return checkup.healthy() ? exit_done : exit_failed;
}

}  // namespace

void add_doctor(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "doctor", "Compare a data folder's jobs with what is on the disk, while no service runs");
  const auto options = std::make_shared<Options>();
  options->data = default_data_folder();
  command->add_option("--data", options->data, "The data folder")
      ->envname("ROULEAU_DATA")
      ->capture_default_str();
  command->add_flag("--deep", options->checkup.deep, "Read every archive and compare its SHA-256");
  command->add_flag("--mend", options->checkup.mend,
                    "Put what nothing needs into lost+found; mark jobs whose archive is lost as failed");
  command->add_flag("--json", action.json, "Print the findings as JSON");
  command->footer(
      "Exit codes: 0 healthy, 1 something was found that is not mended, 2 no such folder, or in use.");
  command->callback(
      [&action, options] { action.run = [&action, options] { return doctor(*options, action.json); }; });
}

}  // namespace rouleau::service
