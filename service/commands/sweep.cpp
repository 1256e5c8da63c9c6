#include <algorithm>
#include <memory>
#include <thread>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/commands/case_file.h"
#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/sweep_here.h"
#include "service/commands/sweep_there.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string file;
  std::string folder;
  SweepHereOptions here;
  ClientOptions client;
  bool wait = false;
};

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "sweep", "Run a case at many values, here on all cores or on a service; run again, it goes on");
  const auto options = std::make_shared<Options>();
  options->here.workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command->add_option("SWEEP.json", options->file, "The case and its axes")->required();
  command->add_option("-o,--output", options->folder,
                      "Folder of the archives, table.csv and sweep.json (default here: the file's name; on a "
                      "service: none are fetched)");
  command->add_option("--workers", options->here.workers, "Points run here at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      ->add_option("--checkpoint-interval", options->here.checkpoint_interval,
                   "Seconds between the checkpoints of a point that runs here; 0: none")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--max-sweep", options->here.most_points, "The most points that are taken here")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--wait", options->wait, "On a service: wait until all points have ended");
  command->add_flag("--json", action.json, "Print the table and the counts, or the service's sweep, as JSON");
  // Not from ROULEAU_SERVER alone: what runs here must not go elsewhere unasked.
  auto* const server = add_client_options(*command, options->client);
  server->envname("")->description("URL of a service to run it on, instead of here");
  command->callback([&action, options, server] {
    const bool there = server->count() > 0;
    action.run = [&action, options, there] {
      const nlohmann::json given = parse_json(read_case_file(options->file));
      const std::filesystem::path folder = options->folder.empty() && !there
                                               ? std::filesystem::path(options->file).stem()
                                               : std::filesystem::path(options->folder);
      if (std::error_code none;
          !folder.empty() && std::filesystem::equivalent(options->file, folder / "sweep.json", none)) {
        throw CommandError(exit_bad_input,
                           options->file + " is where the sweep's own sweep.json goes; name another folder");
      }
      if (there) {
        ApiClient client = options->client.connect();
        return sweep_there(client, given, folder, options->wait, action.json);
      }
      return sweep_here(given, folder, options->here, action.json);
    };
  });
}

}  // namespace rouleau::service
