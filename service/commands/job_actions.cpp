#include <iostream>
#include <memory>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

/// A request about one job that is answered with the job.
void add_action(CLI::App& app, Action& action, const std::string& verb, const std::string& help) {
  auto* const command = app.add_subcommand(verb, help);
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job")->required();
  command->add_flag("--json", action.json, "Print the job as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, id, verb] {
    action.run = [&action, options, id, verb] {
      ApiClient client = options->connect();
      const auto job = client.post(job_path(*id) + ':' + verb);
      if (action.json) {
        std::cout << dump(job) << '\n';
      } else {
        std::cout << *id << ' ' << job.at("state").get<std::string>() << '\n';
      }
      return exit_done;
    };
  });
}

}  // namespace

void add_job_actions(CLI::App& app, Action& action) {
  add_action(app, action, "cancel", "Cancel a job of a running service");
  add_action(app, action, "pause", "Stop a job at a checkpoint, to go on from later");
  add_action(app, action, "resume", "Let a paused job go on");
  add_action(app, action, "retry", "Run a job again that failed or was cancelled");
}

void add_delete(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("delete", "Remove a job that has ended, with its files");
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job")->required();
  command->add_flag("--json", action.json, "Print its id as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, id] {
    action.run = [&action, options, id] {
      options->connect().remove(job_path(*id));
      std::cout << (action.json ? dump({{"deleted", *id}}) : *id + " deleted") << '\n';
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
