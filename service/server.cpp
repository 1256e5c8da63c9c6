#include "service/server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "service/api/page.h"
#include "service/api/service.h"
#include "service/http/guarded_server.h"
#include "service/interrupt.h"
#include "service/log.h"
#include "service/metrics.h"
#include "service/metrics_reading.h"

namespace rouleau::service {

namespace {

constexpr std::size_t health_threads = 4;

/// A server together with the thread that it answers on.
class RunningServer {
 public:
  RunningServer(Router router, ServerSettings settings, const std::string& host, int port)
      : server_(std::move(router), std::move(settings)), port_(server_.listen_on(host, port)) {}
  ~RunningServer() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;

  void start() {
    thread_ = std::thread([this] { server_.serve(); });
  }
  int port() const { return port_; }
  std::size_t connections() const { return server_.connections(); }

 private:
  GuardedServer server_;
  int port_;
  std::thread thread_;
};

Router make_routes(Service& service, const std::filesystem::path& web) {
  Router router;
  add_jobs(router, service);
  add_job(router, service);
  add_queue(router, service);
  add_job_actions(router, service);
  add_events(router, service);
  add_log(router, service);
  add_sweeps(router, service);
  add_sweep(router, service);
  add_series(router, service);
  add_frames(router, service);
  add_probes(router, service);
  add_archive(router, service);
  add_cases(router, service);
  add_problems(router);
  add_openapi(router);
  const std::filesystem::path folder = web.empty() ? std::filesystem::path(ROULEAU_WEB_DIR) : web;
  if (add_page(router, folder) == 0) log::warn("there is no web page", {{"folder", folder.string()}});
  return router;
}

Router make_health_routes(const std::atomic<bool>& draining, std::function<std::string()> metrics) {
  Router router;
  add_health(router, draining);
  add_metrics(router, std::move(metrics));
  return router;
}

/// Each connection takes a descriptor, and the usual limit for a process is 1024.
void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= limit.rlim_max) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

/// 0: only when a run is stopped.
std::chrono::duration<double> checkpoint_interval(double seconds) {
  return std::chrono::duration<double>(seconds > 0 ? seconds : std::numeric_limits<double>::infinity());
}

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1e3 * seconds));
}

constexpr double rate_limit_with_tokens = 50;

RateLimit rate_limit(const ServeOptions& options) {
  const double rate = options.rate_limit.value_or(options.token_file.empty() ? 0 : rate_limit_with_tokens);
  return {rate, options.rate_burst.value_or(std::max(1.0, 2 * rate))};
}

/// Those in use stay if the file cannot be read.
void read_tokens_again(const std::filesystem::path& file, Access& access, Streams& streams) {
  try {
    access.replace_tokens(read_tokens(file));
    ++streams.epoch;
    log::info("tokens read again", {{"file", file.string()}});
  } catch (const std::exception& error) {
    log::error("the tokens in use stay", {{"error", error.what()}});
  }
}

/// Waits for the signal that ends the service.
int serve_until_signal(const ServeOptions& options, Access& access, Streams& streams) {
  for (;;) {
    const int signal = wait_for_interrupt();
    if (signal != SIGHUP || options.token_file.empty()) return signal;
    read_tokens_again(options.token_file, access, streams);
  }
}

/// Written aside and renamed: whoever sees it sees the whole number.
void write_port_file(const std::filesystem::path& file, int port) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream(part) << port << '\n';
  std::filesystem::rename(part, file);
}

}  // namespace

void serve(const ServeOptions& options) {
  // Before any thread is made, so that all of them leave these signals to `wait_for_interrupt`.
  block_interrupts();
  raise_descriptor_limit();
  // A limit on the size of files is to be told like a full disk, not to end the process.
  std::signal(SIGXFSZ, SIG_IGN);
  ServerSettings settings;
  const auto access = options.token_file.empty() ? std::make_shared<Access>()
                                                 : std::make_shared<Access>(read_tokens(options.token_file));
  settings.access = access;
  settings.rate = rate_limit(options);
  ServerSettings health_settings;
  health_settings.threads = health_threads;

  Metrics metrics;
  settings.on_answer = [&metrics](const Answered& answered) { metrics.note_answer(answered); };

  storage::JobStore store(options.data);
  std::atomic<bool> draining = false;
  KnownMachine machine(options.data);
  Queue queue(store, options.data, machine, checkpoint_interval(options.checkpoint_interval));
  ArchiveUse archive_use;
  Retention retention(store, archive_use, options.data, options.retention,
                      [&](const std::string& id, const std::optional<std::string>& archive_id) {
                        queue.forget(id, archive_id);
                      });
  Service service{store,
                  queue,
                  draining,
                  machine,
                  QueueRoom(store, options.most_queued, [&] { retention.check_room(); }),
                  options.most_points};
  service.archive_use = archive_use;
  service.streams.most = options.max_streams;
  service.streams.comment_interval = milliseconds(options.stream_heartbeat);
  // Streams take their threads from no one.
  settings.threads += static_cast<std::size_t>(options.max_streams);
  RunningServer api(make_routes(service, options.web), std::move(settings), options.host, options.port);
  std::optional<RunningServer> health;
  if (options.health_port != 0) {
    const auto read = [&] { return metrics.text(read_metrics(service, api.connections(), options.data)); };
    health.emplace(make_health_routes(draining, read), health_settings, "127.0.0.1", options.health_port);
  }

  queue.watch([&](const storage::Job& job) {
    if (const auto after = store.find(job.id)) {
      metrics.note_attempt(job, after->state, storage::system_clock_ms());
    }
  });

  // Only now that the addresses are ours is a job touched.
  queue.start(options.workers);
  retention.start();
  if (health) health->start();
  api.start();
  const std::string url = "http://" + options.host + ":" + std::to_string(api.port());
  log::info("serving", {{"url", url},
                        {"data", options.data.string()},
                        {"workers", std::to_string(options.workers)},
                        {"health_port", std::to_string(options.health_port)}});
  if (!options.port_file.empty()) write_port_file(options.port_file, api.port());
  if (options.json) {
    std::cout << nlohmann::json{{"url", url}, {"health_port", options.health_port}}.dump() << std::endl;
  } else {
    std::cout << "serving " << url << " with its data in " << options.data.string() << std::endl;
  }

  const int signal = serve_until_signal(options, *access, service.streams);
  log::info("draining", {{"signal", std::to_string(signal)}});
  draining = true;
  queue.drain();
  log::info("drained");
}

}  // namespace rouleau::service
