#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "service/client/api_client.h"

namespace rouleau::service {

/// Which jobs of a service a command is about.
struct JobFilter {
  std::vector<std::string> labels;  ///< KEY:VALUE or KEY=VALUE; all must hold
  std::string sweep;
  std::vector<std::string> states;

  bool is_empty() const { return labels.empty() && sweep.empty() && states.empty(); }
};

/// --label and --sweep, and --state if `with_states`.
void add_job_filter(CLI::App& command, JobFilter& filter, bool with_states);

/// "key=value" or "key:value" of --label, as both of submit's and the lists' are taken.
/// @throws CommandError (bad input)
std::pair<std::string, std::string> read_label(const std::string& text);

/// The jobs that fit, newest first, page by page.
void for_each_job(ApiClient& client, const JobFilter& filter,
                  const std::function<void(const nlohmann::json&)>& visit);

/// The newest of them, at most a page.
nlohmann::json newest_jobs(ApiClient& client, const JobFilter& filter, int most);

}  // namespace rouleau::service
