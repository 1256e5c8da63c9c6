#include <utility>

#include <nlohmann/json.hpp>

#include "service/api/job_json.h"
#include "service/api/new_job.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/api/store_problems.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/log.h"

namespace rouleau::service {

namespace {

/// What was answered before to a request with this key is answered again whatever has become of the queue.
storage::Submission store(Service& service, const Call& call,
                          const std::optional<storage::IdempotencyKey>& key) {
  return submitted([&] {
    if (key) {
      if (auto earlier = service.store.find_submission(*key)) return std::move(*earlier);
    }
    storage::NewJob wanted = read_new_job(call, service.machine);
    service.room.enter(1);
    return service.store.submit(std::move(wanted), key);
  });
}

/// A job as it was when it had just been submitted.
storage::Job as_submitted(storage::Job job) {
  const bool succeeded_at_once = job.result_of && job.ended_at == job.created_at;
  if (succeeded_at_once) return job;
  storage::Job first;
  first.id = job.id;
  first.name = job.name;
  first.case_hash = job.case_hash;
  first.labels = job.labels;
  first.lane = job.lane;
  first.priority = job.priority;
  first.fresh = job.fresh;
  first.created_at = job.created_at;
  first.plan = job.plan;
  return first;
}

void submit(Service& service, const Call& call, httplib::Response& response) {
  if (service.draining)
    throw Problem(problems::draining, "no new jobs are taken while the server shuts down");
  check_query(call, {});
  const auto key = idempotency_key(call);
  const KeysInFlight::Hold hold(service.keys, key);
  auto [job, replayed] = store(service, call, key);
  if (replayed) {
    job = as_submitted(std::move(job));
    response.set_header("Idempotency-Replayed", "true");
  } else {
    service.queue.wake();
    log::info("job accepted", {{"request", call.request_id},
                               {"caller", call.caller},
                               {"job", job.id},
                               {"name", job.name},
                               {"result_of", job.result_of.value_or("")}});
  }
  response.set_header("Location", "/v1/jobs/" + job.id);
  response.set_header("Retry-After", "1");
  answer_json_text(job_in_full(service, job), response, 202);
}

storage::JobQuery read_list_query(const Call& call) {
  check_query(call, {"page_size", "page_token", "sweep"}, {"state", "label"});
  storage::JobQuery wanted;
  std::vector<Fault> faults;
  const auto [first_state, last_state] = call.request.params.equal_range("state");
  for (auto it = first_state; it != last_state; ++it) {
    for (const std::string& name : split_list(it->second)) {
      if (const auto state = storage::parse_job_state(name)) {
        wanted.states.push_back(*state);
      } else {
        faults.push_back({"?state",
                          "no state of this name; there are queued, running, paused, cancelling, "
                          "succeeded, failed, cancelled"});
      }
    }
  }
  const auto [first_label, last_label] = call.request.params.equal_range("label");
  for (auto it = first_label; it != last_label; ++it) {
    const auto colon = it->second.find(':');
    if (colon == std::string::npos) {
      faults.push_back({"?label", "must be KEY:VALUE"});
    } else {
      wanted.labels.emplace_back(it->second.substr(0, colon), it->second.substr(colon + 1));
    }
  }
  if (!faults.empty()) throw Problem(problems::invalid_request, "the query is not valid", std::move(faults));
  wanted.page_size = query_integer(call, "page_size", 1, 1000).value_or(wanted.page_size);
  wanted.sweep = query(call, "sweep").value_or("");
  wanted.page_token = query(call, "page_token").value_or("");
  return wanted;
}

void list(Service& service, const Call& call, httplib::Response& response) {
  const storage::JobQuery wanted = read_list_query(call);
  const storage::JobPage page = listed([&] { return service.store.list(wanted); });
  nlohmann::json body{{"jobs", nlohmann::json::array()}};
  for (const storage::Job& job : page.jobs) body["jobs"].push_back(to_json(job, service.queue.live()));
  if (page.next_page_token) body["next_page_token"] = *page.next_page_token;
  answer_json(body, response);
}

}  // namespace

void add_jobs(Router& router, Service& service) {
  router.add(
      "POST", "/v1/jobs",
      [&service](const Call& call, httplib::Response& response) { submit(service, call, response); },
      Body::json);
  router.add("GET", "/v1/jobs",
             [&service](const Call& call, httplib::Response& response) { list(service, call, response); });
}

}  // namespace rouleau::service
