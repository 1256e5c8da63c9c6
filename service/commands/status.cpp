#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/job_filter.h"
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

struct Options {
  ClientOptions client;
  std::string id;
  JobFilter filter;
  int most = 50;
};

int status(const Options& options, bool json) {
  ApiClient client = options.client.connect();
  const std::string& id = options.id;
  const auto answer =
      id.empty() ? newest_jobs(client, options.filter, options.most) : client.get(job_path(id));
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
  const auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "The job; without it, the newest");
  command->add_option("-n,--most", options->most, "How many of the newest")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_job_filter(*command, options->filter, true);
  command->add_flag("--json", action.json, "Print as JSON");
  add_client_options(*command, options->client);
  command->callback(
      [&action, options] { action.run = [&action, options] { return status(*options, action.json); }; });
}

}  // namespace rouleau::service
