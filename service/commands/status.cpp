#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/progress_line.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

void print_line(const nlohmann::json& job) {
  std::string progress;
  if (const auto found = job.find("progress"); found != job.end() && found->is_object()) {
    progress = fmt::format("{:5.1f} %", 100 * found->value("fraction", 0.0));
    if (job.at("state") == "running")
      progress += "  " + format_time_left(found->value("eta_s", 0.0)) + " left";
  }
  std::cout << fmt::format("{}  {:10}  {}  {:20}  {}\n", job.at("id").get<std::string>(),
                           job.at("state").get<std::string>(), job.at("created_at").get<std::string>(),
                           job.at("name").get<std::string>(), progress);
}

int status(const ClientOptions& options, const std::string& id, bool json) {
  ApiClient client = options.connect();
  const auto answer = client.get(id.empty() ? "/v1/jobs" : job_path(id));
  if (json) {
    std::cout << dump(answer) << '\n';
    return exit_done;
  }
  if (!id.empty()) {
    print_line(answer);
    if (const auto error = answer.find("error"); error != answer.end() && error->is_object()) {
      std::cout << error->value("message", "") << '\n';
    }
    return exit_done;
  }
  for (const auto& job : answer.at("jobs")) print_line(job);
  return exit_done;
}

}  // namespace

void add_status(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("status", "Show a job of a running service, or its newest jobs");
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job; without it, the newest 50");
  command->add_flag("--json", action.json, "Print as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, id] {
    action.run = [&action, options, id] { return status(*options, *id, action.json); };
  });
}

}  // namespace rouleau::service
