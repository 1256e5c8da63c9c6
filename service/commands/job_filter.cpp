#include "service/commands/job_filter.h"

#include <utility>

#include <httplib.h>

#include "service/commands/command.h"

namespace rouleau::service {

namespace {

std::string list_path(const JobFilter& filter, int page_size) {
  std::string path = "/v1/jobs?page_size=" + std::to_string(page_size);
  const auto add = [&path](const char* name, const std::string& value) {
    path += std::string("&") + name + '=' + httplib::detail::encode_query_param(value);
  };
  for (const std::string& label : filter.labels) {
    const auto [key, value] = read_label(label);
    add("label", key + ':' + value);
  }
  for (const std::string& state : filter.states) add("state", state);
  if (!filter.sweep.empty()) add("sweep", filter.sweep);
  return path;
}

}  // namespace

void add_job_filter(CLI::App& command, JobFilter& filter, bool with_states) {
  command.add_option("--label", filter.labels, "key=value: jobs with this label; repeated, with all of them")
      ->allow_extra_args(false);
  command.add_option("--sweep", filter.sweep, "Jobs of this sweep");
  if (with_states) {
    command.add_option("--state", filter.states, "Jobs in this state; several with commas")->delimiter(',');
  }
}

std::pair<std::string, std::string> read_label(const std::string& text) {
  const auto end = text.find_first_of(":=");
  if (end == std::string::npos) throw CommandError(exit_bad_input, "--label takes key=value, not " + text);
  return {text.substr(0, end), text.substr(end + 1)};
}

void for_each_job(ApiClient& client, const JobFilter& filter,
                  const std::function<void(const nlohmann::json&)>& visit) {
  const std::string path = list_path(filter, 200);
  std::string token;
  do {
    const auto page = client.get(path + "&page_token=" + token);
    for (const auto& job : page.at("jobs")) visit(job);
    token = page.value("next_page_token", "");
  } while (!token.empty());
}

nlohmann::json newest_jobs(ApiClient& client, const JobFilter& filter, int most) {
  return client.get(list_path(filter, most));
}

}  // namespace rouleau::service
