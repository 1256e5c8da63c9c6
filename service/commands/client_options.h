#pragma once

#include <chrono>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "service/client/api_client.h"

namespace rouleau::service {

/// What every command needs that speaks to a server.
struct ClientOptions {
  std::string server = "http://127.0.0.1:8080";
  std::string token;
  int patience = 60;  ///< s

  ApiClient connect() const { return {server, token, std::chrono::seconds(patience)}; }
};

/// --server (or ROULEAU_SERVER), --token (or ROULEAU_TOKEN) and --patience.
/// @return --server
CLI::Option* add_client_options(CLI::App& command, ClientOptions& options);

/// An id as part of a path.
/// @throws CommandError (bad input) if it is none
std::string job_path(const std::string& id);
std::string sweep_path(const std::string& id);

bool has_ended(const nlohmann::json& job);

/// Follows a job until it has ended, showing its progress.
/// @return the job
nlohmann::json follow_job(ApiClient& client, const std::string& id);

/// Prints how a job ended: its summary or its error.
/// @return the exit code that stands for it
int report_end(const nlohmann::json& job, bool json);

}  // namespace rouleau::service
