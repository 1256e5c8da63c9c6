#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "service/client/server_error.h"
#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/commands/job_filter.h"
#include "service/commands/progress_line.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

struct Options {
  ClientOptions client;
  std::string id;
  bool all = false;
  JobFilter filter;
};

const std::vector<std::string> active{"queued", "running", "paused", "cancelling"};

std::string state_of(ApiClient& client, const std::string& id) {
  try {
    return client.get(job_path(id)).at("state");
  } catch (const ServerError& error) {
    if (error.status() != 404 && error.status() != 410) throw;
    return "deleted";
  }
}

/// The states of jobs by their ids, followed until all have ended.
class Followed {
 public:
  /// Those with the labels or of the sweep, ended ones too; without either, those that are active now.
  Followed(ApiClient& client, JobFilter filter) : client_(client), filter_(std::move(filter)) {
    if (filter_.is_empty()) filter_.states = active;
    for_each_job(client_, filter_, [&](const nlohmann::json& job) {
      states_[job.at("id")] = job.at("state");
      if (!has_ended(job)) active_.insert(job.at("id").get<std::string>());
    });
    filter_.states = active;
  }

  /// Asks until none of them is active any more.
  void wait() {
    ProgressLine line;
    while (!active_.empty()) {
      const std::size_t ended = states_.size() - active_.size();
      line.show(static_cast<double>(ended) / static_cast<double>(states_.size()),
                fmt::format("{} of {} jobs have ended", ended, states_.size()));
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      look();
    }
  }

  const std::map<std::string, std::string>& states() const { return states_; }

 private:
  void look() {
    std::set<std::string> still;
    for_each_job(client_, filter_, [&](const nlohmann::json& job) { still.insert(job.at("id")); });
    for (auto it = active_.begin(); it != active_.end();) {
      if (still.contains(*it)) {
        ++it;
        continue;
      }
      states_[*it] = state_of(client_, *it);
      it = active_.erase(it);
    }
  }

  ApiClient& client_;
  JobFilter filter_;
  std::map<std::string, std::string> states_;
  std::set<std::string> active_;
};

int wait_for_all(const Options& options, bool json) {
  ApiClient client = options.client.connect();
  Followed jobs(client, options.filter);
  jobs.wait();
  std::map<std::string, std::size_t> counts;
  for (const auto& [id, state] : jobs.states()) ++counts[state];
  if (json) {
    std::cout << dump({{"jobs", jobs.states()}, {"counts", counts}}) << '\n';
  } else {
    for (const auto& [state, count] : counts) std::cout << count << ' ' << state << '\n';
  }
  return counts["succeeded"] == jobs.states().size() ? exit_done : exit_failed;
}

int wait(const Options& options, bool json) {
  if (options.id.empty() != (options.all || !options.filter.is_empty())) {
    throw CommandError(exit_bad_input, "wait takes the id of a job, or --all, --label or --sweep");
  }
  if (options.id.empty()) return wait_for_all(options, json);
  ApiClient client = options.client.connect();
  return report_end(follow_job(client, options.id), json);
}

}  // namespace

void add_wait(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("wait", "Follow jobs until they have ended; exit code 1 if not all succeeded");
  const auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "The job");
  command->add_flag("--all", options->all,
                    "All jobs with the label or of the sweep; without these, all that have not ended yet");
  add_job_filter(*command, options->filter, false);
  command->add_flag("--json", action.json, "Print as JSON how they ended");
  add_client_options(*command, options->client);
  command->callback(
      [&action, options] { action.run = [&action, options] { return wait(*options, action.json); }; });
}

}  // namespace rouleau::service
