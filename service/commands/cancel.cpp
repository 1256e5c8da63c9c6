#include <iostream>
#include <memory>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

void add_cancel(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("cancel", "Cancel a job of a running service");
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job")->required();
  command->add_flag("--json", action.json, "Print the job as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, id] {
    action.run = [&action, options, id] {
      ApiClient client = options->connect();
      const auto job = client.post(job_path(*id) + ":cancel", nullptr);
      if (action.json) {
        std::cout << dump(job) << '\n';
      } else {
        std::cout << *id << ' ' << job.at("state").get<std::string>() << '\n';
      }
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
