#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

void add_queue(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("queue", "Show the queue of a running service, or pause it");
  const auto options = std::make_shared<ClientOptions>();
  const auto verb = std::make_shared<std::string>();
  command->add_option("ACTION", *verb, "pause: begin no further job; resume: go on")
      ->check(CLI::IsMember({"pause", "resume"}));
  command->add_flag("--json", action.json, "Print as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, verb] {
    action.run = [&action, options, verb] {
      ApiClient client = options->connect();
      const auto queue = verb->empty() ? client.get("/v1/queue") : client.post("/v1/queue:" + *verb);
      if (action.json) {
        std::cout << dump(queue) << '\n';
        return exit_done;
      }
      for (const auto& [key, value] : queue.items()) {
        std::cout << fmt::format("{:16} {}\n", key,
                                 value.is_string() ? value.get<std::string>() : dump(value));
      }
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
