#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "service/client/server_error.h"
#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/fetch_archive.h"
#include "service/commands/job_filter.h"
#include "service/commands/progress_line.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

struct Options {
  ClientOptions client;
  std::string id;
  std::string output;
  bool all = false;
  JobFilter filter;
};

int fetch_one(const Options& options, bool json) {
  ApiClient client = options.client.connect();
  const std::filesystem::path file = options.output.empty() ? options.id + ".h5" : options.output;
  const auto fetched = fetch_archive(client, options.id, file);
  std::cout << (json ? dump(fetched) : file.string()) << '\n';
  return exit_done;
}

int fetch_all(const Options& options, bool json) {
  ApiClient client = options.client.connect();
  JobFilter filter = options.filter;
  if (filter.states.empty()) filter.states = {"succeeded", "failed"};
  std::vector<std::string> ids;
  for_each_job(client, filter, [&](const nlohmann::json& job) { ids.push_back(job.at("id")); });
  const std::filesystem::path folder = options.output.empty() ? "." : options.output;
  std::filesystem::create_directories(folder);

  auto archives = nlohmann::json::array();
  std::size_t without = 0;
  {
    ProgressLine line;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      line.show(static_cast<double>(k) / static_cast<double>(ids.size()),
                fmt::format("{} of {} archives", k, ids.size()));
      try {
        archives.push_back(fetch_archive(client, ids[k], folder / (ids[k] + ".h5")));
      } catch (const ServerError& error) {
        if (!has_no_archive(error)) throw;
        ++without;
      }
    }
  }
  if (json) {
    std::cout << dump({{"archives", archives}, {"without", without}}) << '\n';
  } else {
    std::cout << fmt::format("{} archives in {}, {} jobs have none\n", archives.size(), folder.string(),
                             without);
  }
  return exit_done;
}

int fetch(const Options& options, bool json) {
  if (options.id.empty() != (options.all || !options.filter.is_empty())) {
    throw CommandError(exit_bad_input, "fetch takes the id of a job, or --all, --label, --sweep or --state");
  }
  return options.id.empty() ? fetch_all(options, json) : fetch_one(options, json);
}

}  // namespace

void add_fetch(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "fetch",
      "Download archives of jobs that succeeded or went unstable; what is there is not fetched again");
  const auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "The job");
  command->add_option("-o,--output", options->output,
                      "The file (default: ID.h5, here); of several jobs, the folder (default: this one)");
  command->add_flag("--all", options->all, "Of all jobs, or all that the options below name");
  add_job_filter(*command, options->filter, true);
  command->add_flag("--json", action.json, "Print names, sizes and sha256 as JSON");
  add_client_options(*command, options->client);
  command->callback(
      [&action, options] { action.run = [&action, options] { return fetch(*options, action.json); }; });
}

}  // namespace rouleau::service
