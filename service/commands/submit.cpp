#include <iostream>
#include <memory>
#include <vector>

#include "engine/case/case_json.h"
#include "service/commands/case_file.h"
#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/job_filter.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

struct Options {
  ClientOptions client;
  std::string file;
  int priority = 0;
  std::vector<std::string> labels, settings;
  std::string key;
  bool fresh = false;
  bool wait = false;
};

nlohmann::json read_labels(const std::vector<std::string>& labels) {
  auto json = nlohmann::json::object();
  for (const std::string& label : labels) {
    const auto [key, value] = read_label(label);
    json[key] = value;
  }
  return json;
}

int submit(const Options& options, bool json) {
  auto document = parse_json(read_case_file(options.file));
  apply_settings(document, options.settings);
  ApiClient client = options.client.connect();
  nlohmann::json body{
      {"case", std::move(document)}, {"priority", options.priority}, {"labels", read_labels(options.labels)}};
  if (options.fresh) body["fresh"] = true;
  auto job = client.post_once("/v1/jobs", body, options.key.empty() ? new_idempotency_key() : options.key);
  const std::string id = job.at("id");
  if (!options.wait) {
    if (json) {
      std::cout << dump(job) << '\n';
    } else {
      std::cout << id << '\n' << client.url() << job_path(id) << '\n';
    }
    return exit_done;
  }
  return report_end(follow_job(client, id), json);
}

}  // namespace

void add_submit(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("submit", "Hand a case to a running service; print the job's id and URL");
  const auto options = std::make_shared<Options>();
  command->add_option("CASE.json", options->file, "The case")->required();
  command->add_option("--set", options->settings, "/json/pointer=value: change the case; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--priority", options->priority, "-100 to 100; the higher runs first")
      ->capture_default_str();
  command->add_option("--label", options->labels, "key=value; may be repeated")->allow_extra_args(false);
  command->add_flag("--fresh", options->fresh, "Compute it even if its result is there");
  command->add_option("--idempotency-key", options->key,
                      "A name for this submission: given again, it is not submitted again");
  command->add_flag("--wait", options->wait, "Wait until it has ended; exit code 1 if it failed");
  command->add_flag("--json", action.json, "Print the job as JSON");
  add_client_options(*command, options->client);
  command->callback(
      [&action, options] { action.run = [&action, options] { return submit(*options, action.json); }; });
}

}  // namespace rouleau::service
