#include <filesystem>
#include <limits>
#include <memory>

#include <nlohmann/json.hpp>

#include "service/api/service.h"
#include "service/http/problem.h"
#include "service/http/request_head.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

namespace {

/// The routes over a store with a few jobs in it, which nobody runs.
class Api {
 public:
  Api() {
    for (int i = 0; i < 5; ++i) {
      storage::NewJob job;
      job.case_hash = std::string(64, static_cast<char>('0' + i));
      job.case_given = job.case_resolved = job.plan = "{}";
      job.labels = R"({"a":"b"})";
      store_.submit(std::move(job));
    }
    service::add_jobs(router_, service_);
    service::add_queue(router_, service_);
    service::add_job(router_, service_);
    service::add_log(router_, service_);
    service::add_series(router_, service_);
    service::add_frames(router_, service_);
    service::add_probes(router_, service_);
    service::add_archive(router_, service_);
    service::add_problems(router_);
  }
  ~Api() { std::filesystem::remove_all(folder_); }

  void get(const std::string& target) {
    const auto match = router_.find("GET", service::path_of(target));
    if (match.route == nullptr) return;
    httplib::Request request;
    request.method = "GET";
    request.target = target;
    request.path = service::path_of(target);
    request.params = service::query_of(target);
    httplib::Response response;
    match.route->handler(service::Call{request, match.parts, "", ""}, response);
  }

 private:
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("rouleau-fuzz-" + std::to_string(::getpid()));
  storage::JobStore store_{folder_};
  std::atomic<bool> draining_ = false;
  service::KnownMachine machine_{folder_};
  service::Queue queue_{store_, folder_, machine_,
                        std::chrono::duration<double>(std::numeric_limits<double>::infinity())};
  service::Service service_{store_, queue_, draining_, machine_, service::QueueRoom(store_, 1000)};
  service::Router router_;
};

}  // namespace

/// The target of a GET.
void query(std::string_view input) {
  static Api api;
  if (input.size() > service::RequestLimits().target_bytes) return;
  try {
    api.get(std::string(input));
  } catch (const service::Problem& problem) {
    service::dump(service::to_json(problem, ""));
  }
}

}  // namespace rouleau::fuzz
