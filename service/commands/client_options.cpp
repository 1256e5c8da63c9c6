#include "service/commands/client_options.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <iostream>
#include <thread>

#include "service/commands/command.h"
#include "service/commands/progress_line.h"
#include "service/commands/run_summary_text.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

double number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

Progress progress_of(const nlohmann::json& json) {
  Progress progress;
  progress.simulated_time = number(json, "simulated_time");
  progress.duration = number(json, "duration");
  progress.fraction = number(json, "fraction");
  progress.steps_per_second = number(json, "steps_per_second");
  progress.eta_s = number(json, "eta_s");
  return progress;
}

const std::string& checked(const std::string& id, const char* of) {
  const bool plain = !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
    return std::isxdigit(static_cast<unsigned char>(c)) != 0 || c == '-';
  });
  if (!plain) throw CommandError(exit_bad_input, id + " is not the id of " + of);
  return id;
}

}  // namespace

CLI::Option* add_client_options(CLI::App& command, ClientOptions& options) {
  command.add_option("--token", options.token, "Token, where the server asks for one")
      ->envname("ROULEAU_TOKEN");
  command
      .add_option("--patience", options.patience,
                  "Seconds to keep asking a server that is busy, or has gone away meanwhile")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  return command.add_option("--server", options.server, "URL of the service")
      ->envname("ROULEAU_SERVER")
      ->capture_default_str();
}

std::string job_path(const std::string& id) {
  return "/v1/jobs/" + checked(id, "a job");
}

std::string sweep_path(const std::string& id) {
  return "/v1/sweeps/" + checked(id, "a sweep");
}

bool has_ended(const nlohmann::json& job) {
  const auto& state = job.at("state");
  return state == "succeeded" || state == "failed" || state == "cancelled";
}

nlohmann::json follow_job(ApiClient& client, const std::string& id) {
  ProgressLine line;
  for (;;) {
    // A server with too many that wait answers at once.
    const auto next = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    auto job = client.get(job_path(id) + "?wait=1s");
    if (const auto& progress = job["progress"]; progress.is_object()) line.show(progress_of(progress));
    if (has_ended(job)) return job;
    std::this_thread::sleep_until(next);
  }
}

int report_end(const nlohmann::json& job, bool json) {
  const std::string state = job.at("state");
  if (json) {
    std::cout << dump(job) << '\n';
  } else {
    std::cout << job.at("id").get<std::string>() << ' ' << state << '\n';
    if (const auto summary = job.find("summary"); summary != job.end() && summary->is_object()) {
      std::cout << describe_summary(*summary);
    }
  }
  if (const auto error = job.find("error"); error != job.end() && error->is_object()) {
    std::cerr << "error: " << error->value("message", "") << '\n';
  }
  return state == "succeeded" ? exit_done : exit_failed;
}

}  // namespace rouleau::service
