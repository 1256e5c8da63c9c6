#include <memory>

#include "service/commands/client_options.h"
#include "service/commands/command.h"

namespace rouleau::service {

void add_wait(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("wait", "Follow a job until it has ended; exit code 1 if it failed");
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job")->required();
  command->add_flag("--json", action.json, "Print the job as JSON once it has ended");
  add_client_options(*command, *options);
  command->callback([&action, options, id] {
    action.run = [&action, options, id] {
      ApiClient client = options->connect();
      return report_end(follow_job(client, *id), action.json);
    };
  });
}

}  // namespace rouleau::service
