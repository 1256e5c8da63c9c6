#include "engine/simulation/run.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <stop_token>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/plan/plan.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/commands/progress_line.h"
#include "service/commands/run_summary_text.h"
#include "service/http/problem.h"
#include "service/interrupt.h"
#include "service/queue/fan_out.h"
#include "storage/archive_writer.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string file;
  std::string archive;
  std::vector<std::string> settings;
};

class ProgressOutput : public Output {
 public:
  void progress(const Progress& progress) override { line_.show(progress); }

 private:
  ProgressLine line_;
};

int run(const Options& options, bool json) {
  std::stop_source stop;
  const InterruptHandler interrupts([&stop] { stop.request_stop(); });
  const std::string given = read_case_file(options.file);
  auto document = parse_json(given);
  apply_settings(document, options.settings);
  const Case resolved = read_case(document, check_effects);
  const std::filesystem::path archive =
      options.archive.empty() ? std::filesystem::path(options.file).filename().replace_extension(".h5")
                              : std::filesystem::path(options.archive);

  storage::ArchiveWriter writer(archive, options.settings.empty() ? given : dump(document));
  RunSummary summary;
  {
    ProgressOutput progress;
    FanOut output(writer, progress);
    summary = run_case(resolved, output, stop.get_token());
  }
  // A run that was interrupted is kept as far as it came.
  const storage::ArchiveFile file = writer.finish(summary);
  if (json) {
    std::cout << dump({{"archive", archive.string()},
                       {"size", file.size},
                       {"sha256", file.sha256},
                       {"summary", to_json(summary)}})
              << '\n';
  } else {
    std::cout << describe_summary(to_json(summary)) << "archive: " << archive.string() << '\n';
  }
  return summary.ending == Ending::stopped ? exit_failed : exit_done;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("run", "Run one case here and write its archive");
  const auto options = std::make_shared<Options>();
  command->add_option("CASE.json", options->file, "The case")->required();
  command->add_option("-o,--output", options->archive,
                      "The archive (default: the case's name with .h5, here)");
  command->add_option("--set", options->settings, "/json/pointer=value: change the case; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--json", action.json, "Print the summary as JSON");
  command->callback(
      [&action, options] { action.run = [&action, options] { return run(*options, action.json); }; });
}

}  // namespace rouleau::service
