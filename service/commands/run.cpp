#include "engine/simulation/run.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stop_token>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/error/checkpoint_error.h"
#include "engine/plan/plan.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/commands/progress_line.h"
#include "service/commands/resumable_run.h"
#include "service/commands/run_summary_text.h"
#include "service/http/problem.h"
#include "service/interrupt.h"
#include "service/known_machine.h"
#include "service/queue/failure.h"
#include "storage/interrupted_run.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string file;
  std::string archive;
  std::vector<std::string> settings;
  bool resume = false;
  double checkpoint_interval = 60;
};

class ProgressOutput : public Output {
 public:
  void progress(const Progress& progress) override { line_.show(progress); }

 private:
  ProgressLine line_;
};

std::optional<storage::InterruptedRun> interrupted_run(const std::filesystem::path& archive,
                                                       const Case& resolved) {
  try {
    return storage::find_interrupted(archive, resolved);
  } catch (const CheckpointError& error) {
    throw CommandError(exit_bad_input, std::string(error.what()) + "; without --resume the run begins anew");
  }
}

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

  const auto interrupted = options.resume ? interrupted_run(archive, resolved) : std::nullopt;
  if (interrupted)
    std::cerr << fmt::format("going on from {:.4g} ms\n", 1e3 * interrupted->head.simulated_time);
  const auto [summary, failure, file] = [&] {
    ProgressOutput progress;
    return run_resumable({archive, options.settings.empty() ? given : dump(document), resolved,
                          options.checkpoint_interval, KnownMachine(data_folder()).known()},
                         interrupted, progress, stop.get_token());
  }();
  const bool stopped = summary.ending == Ending::stopped;
  if (failure) std::cerr << "error: " << failure->what() << '\n';
  if (json) {
    nlohmann::json told = {{"archive", archive.string()},
                           {"size", file.size},
                           {"sha256", file.sha256},
                           {"summary", to_json(summary)}};
    if (failure) {
      told["error"] = failure->what();
      told["breach"] = failure_of(*failure).error;
    }
    std::cout << dump(told) << '\n';
  } else {
    std::cout << describe_summary(to_json(summary)) << "archive: " << archive.string() << '\n';
    if (stopped && options.checkpoint_interval > 0) std::cout << "the same command with --resume goes on\n";
  }
  return stopped || failure ? exit_failed : exit_done;
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
  command->add_flag("--resume", options->resume,
                    "Go on from the last checkpoint, if there is one, as if never stopped");
  command
      ->add_option("--checkpoint-interval", options->checkpoint_interval,
                   "Seconds between checkpoints, which lie beside the archive; 0: none")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--json", action.json, "Print the summary as JSON");
  command->callback(
      [&action, options] { action.run = [&action, options] { return run(*options, action.json); }; });
}

}  // namespace rouleau::service
