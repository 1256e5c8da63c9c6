#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/api/case_body.h"
#include "service/api/new_job.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/api/store_problems.h"
#include "service/api/sweep_json.h"
#include "service/case_hash.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/log.h"
#include "service/sweep/sweep_points.h"

namespace rouleau::service {

namespace {

/// The jobs of all points. Without plans: thousands of them would be long and slow to make, and are made
/// quickly when somebody looks at a job.
std::vector<storage::NewJob> jobs_of(const SweepBody& body, const storage::NewJob& settings) {
  std::vector<storage::NewJob> jobs;
  jobs.reserve(body.points);
  for (SweepPoint& point : expand(body)) {
    storage::NewJob& job = jobs.emplace_back(settings);
    const std::string& name = point.resolved.name;
    job.name = name + (name.empty() ? "#" : " #") + std::to_string(jobs.size() - 1);
    job.case_hash = case_hash(point.resolved);
    job.case_given = std::move(point.given);
    job.case_resolved = dump(to_json(point.resolved));
    job.plan = "null";
  }
  return jobs;
}

storage::SweepSubmission store_new(Service& service, const Call& call,
                                   const std::optional<storage::IdempotencyKey>& key) {
  const nlohmann::json document = read_body(call.request.body);
  std::vector<Fault> faults;
  storage::NewJob settings = read_job_settings(document, faults);
  const SweepBody body =
      read_sweep(document, service.most_points, {"priority", "labels", "fresh"}, std::move(faults));
  settings.lane = lane_of(call.caller, settings.labels);
  std::vector<storage::NewJob> jobs = jobs_of(body, settings);
  service.room.enter(static_cast<std::int64_t>(jobs.size()));
  return service.store.submit_sweep(
      {body.name, settings.labels, settings.lane, settings.priority, dump(document)}, std::move(jobs), key);
}

/// What was answered before to a request with this key is answered again whatever has become of the queue.
storage::SweepSubmission store(Service& service, const Call& call,
                               const std::optional<storage::IdempotencyKey>& key) {
  return submitted([&] {
    if (key) {
      if (auto earlier = service.store.find_sweep_submission(*key)) return std::move(*earlier);
    }
    return store_new(service, call, key);
  });
}

void submit(Service& service, const Call& call, httplib::Response& response) {
  if (service.draining)
    throw Problem(problems::draining, "no new jobs are taken while the server shuts down");
  check_query(call, {});
  const auto key = idempotency_key(call);
  const KeysInFlight::Hold hold(service.keys, key);
  const auto [sweep, replayed] = store(service, call, key);
  if (replayed) {
    response.set_header("Idempotency-Replayed", "true");
  } else {
    service.queue.wake();
    log::info("sweep accepted", {{"request", call.request_id},
                                 {"caller", call.caller},
                                 {"sweep", sweep.id},
                                 {"name", sweep.name},
                                 {"jobs", std::to_string(sweep.jobs())}});
  }
  response.set_header("Location", "/v1/sweeps/" + sweep.id);
  response.set_header("Retry-After", "1");
  answer_json(to_json(sweep), response, 202);
}

void list(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"page_size", "page_token"});
  const int page_size = query_integer(call, "page_size", 1, 1000).value_or(50);
  const std::string page_token = query(call, "page_token").value_or("");
  const storage::SweepPage page = listed([&] { return service.store.list_sweeps(page_size, page_token); });
  nlohmann::json body{{"sweeps", nlohmann::json::array()}};
  for (const storage::Sweep& sweep : page.sweeps) body["sweeps"].push_back(to_json(sweep));
  if (page.next_page_token) body["next_page_token"] = *page.next_page_token;
  answer_json(body, response);
}

}  // namespace

void add_sweeps(Router& router, Service& service) {
  router.add(
      "POST", "/v1/sweeps",
      [&service](const Call& call, httplib::Response& response) { submit(service, call, response); },
      Body::json);
  router.add("GET", "/v1/sweeps",
             [&service](const Call& call, httplib::Response& response) { list(service, call, response); });
}

}  // namespace rouleau::service
