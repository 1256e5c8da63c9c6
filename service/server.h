#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "service/retention.h"

namespace rouleau::service {

struct ServeOptions {
  std::string host = "127.0.0.1";
  int port = 8080;
  int health_port = 8081;
  std::filesystem::path data;
  int workers = 1;
  int most_queued = 100'000;         ///< jobs that may wait
  std::size_t most_points = 10'000;  ///< of a sweep
  std::filesystem::path token_file;  ///< empty: no token is asked for
  std::optional<double> rate_limit;  ///< requests a second of a caller; 0: any number
  std::optional<double> rate_burst;  ///< at once
  std::filesystem::path port_file;   ///< empty: none is written
  std::filesystem::path web;         ///< empty: the page built with this program
  double checkpoint_interval = 60;   ///< s; 0: only when a run is stopped
  RetentionRules retention;
  int max_streams = 64;
  double stream_heartbeat = 15;  ///< s
  bool json = false;
};

/// Serves until SIGTERM or SIGINT, then drains: new jobs are refused, runs go back to the queue. SIGHUP has
/// the token file read again, and drains where there is none: then it tells that a terminal was closed.
/// @throws std::runtime_error if an address or the data folder cannot be had
void serve(const ServeOptions& options);

}  // namespace rouleau::service
