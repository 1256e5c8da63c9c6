#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>

#include "service/commands/command.h"
#include "service/http/access.h"
#include "service/known_machine.h"
#include "service/log.h"
#include "service/server.h"

namespace rouleau::service {

namespace {

void add_retention(CLI::App& command, ServeOptions& options) {
  RetentionRules& rules = options.retention;
  command
      .add_option_function<double>(
          "--keep-days",
          [&rules](double days) { rules.keep = std::chrono::duration<double>(days * 24 * 3600); },
          "Remove jobs that ended so many days ago (default: keep them)")
      ->check(CLI::Range(0.0, 1e5));
  command
      .add_option_function<std::uint64_t>(
          "--max-archive-space", [&rules](std::uint64_t bytes) { rules.most_archive_bytes = bytes; },
          "Remove ended jobs, oldest first, when archives take more, such as 500GB")
      ->transform(CLI::AsSizeValue(true));
  command
      .add_option("--min-free", rules.least_free_bytes,
                  "The same, and refuse new jobs, when the disk has less left, such as 5GB")
      ->transform(CLI::AsSizeValue(true));
  command
      .add_option_function<double>(
          "--retention-interval",
          [&rules](double seconds) { rules.interval = std::chrono::duration<double>(seconds); },
          "s between looks at what is to be removed (default: 60)")
      ->check(CLI::Range(0.1, 86400.0));
}

}  // namespace

void add_serve(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("serve", "Run the service: HTTP API, queue, workers and web page");
  const auto options = std::make_shared<ServeOptions>();
  const auto log_level = std::make_shared<std::string>("info");
  const auto log_format = std::make_shared<std::string>("text");
  options->data = default_data_folder();
  options->workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));

  command->add_option("--host", options->host, "Address to listen on; other than loopback needs --token-file")
      ->capture_default_str();
  command->add_option("--port", options->port, "Port; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command
      ->add_option("--health-port", options->health_port,
                   "Port of /livez, /readyz and /metrics on 127.0.0.1; 0: none")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_option("--data", options->data, "Folder of the job store and the archives")
      ->envname("ROULEAU_DATA")
      ->capture_default_str();
  command->add_option("--workers", options->workers, "Jobs run at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--max-sweep", options->most_points, "The most points of a sweep")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--max-queued", options->most_queued, "Jobs that may wait; beyond them 503 queue-full")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  command
      ->add_option(
          "--checkpoint-interval", options->checkpoint_interval,
          "Seconds between checkpoints of a running job; 0: only when it is paused or the service ends")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--max-streams", options->max_streams, "Event streams open at a time")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command
      ->add_option("--stream-heartbeat", options->stream_heartbeat,
                   "Seconds without an event after which a stream sends a comment")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  add_retention(*command, *options);
  command->add_option("--token-file", options->token_file,
                      "Tokens that may call, lines of `rouleau token`; read again on SIGHUP");
  command
      ->add_option("--rate-limit", options->rate_limit,
                   "Requests a second of each token, or of each address where none is needed; 0: any number "
                   "(default: 50 with tokens, else 0)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--rate-burst", options->rate_burst,
                   "Requests that may come at once (default: twice the rate)")
      ->check(CLI::Range(1.0, 1e6));
  command->add_option("--port-file", options->port_file, "Write the port here once it answers");
  command->add_option("--web", options->web,
                      "Folder of the web page (default: the one built with this program)");
  command->add_option("--log-level", *log_level, "What is logged to standard error")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  command->add_option("--log-format", *log_format, "How: key=value, or a JSON object a line")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command->add_flag("--json", action.json, "Print the address as JSON once it answers");
  command->callback([&action, options, log_level, log_format] {
    action.run = [&action, options, log_level, log_format] {
      if (!is_loopback(options->host) && options->token_file.empty()) {
        throw CommandError(exit_bad_input, "listening on " + options->host + " needs --token-file");
      }
      log::set_up(*log_level, *log_format == "json" ? log::Format::json : log::Format::text);
      options->json = action.json;
      serve(*options);
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
