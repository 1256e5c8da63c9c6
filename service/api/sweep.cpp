#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "service/api/etag.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/api/sweep_json.h"
#include "service/api/waiting.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/log.h"
#include "service/sweep/sweep_points.h"
#include "service/sweep/sweep_table.h"

namespace rouleau::service {

namespace {

storage::Sweep find(Service& service, const Call& call) {
  const std::string& id = call.part("id");
  if (auto sweep = service.store.find_sweep(id)) return std::move(*sweep);
  if (service.store.has_expired(id)) {
    throw Problem(problems::expired, "all jobs of the sweep were removed to make room for others");
  }
  throw Problem(problems::not_found, "no sweep has this id");
}

/// Until no job of it is active, or the time is up.
void wait_for_end(Service& service, const std::string& id, std::chrono::milliseconds wait) {
  const auto deadline = SignalBoard::Clock::now() + wait;
  const Waiting waiting(service.waiting);
  if (waiting.too_many()) return;
  std::uint64_t seen = service.queue.changes().version();
  while (service.store.sweep_is_active(id) && service.queue.changes().wait(seen, deadline)) {
    // Of many short jobs one ends every few milliseconds, and looking takes as long.
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    seen = service.queue.changes().version();
  }
}

bool with_jobs(const Call& call) {
  const auto text = query(call, "jobs");
  if (!text || *text == "true") return true;
  if (*text == "false") return false;
  throw Problem(problems::invalid_request, "a query parameter is not valid",
                {{"?jobs", "must be true or false"}});
}

void get(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"wait", "jobs"});
  const bool lists_jobs = with_jobs(call);
  if (const auto wait = read_wait(call); wait.count() > 0) wait_for_end(service, call.part("id"), wait);
  const storage::Sweep sweep = find(service, call);
  nlohmann::json body = to_json(sweep);
  if (lists_jobs) {
    const SweepBody given = body_of(sweep);
    auto& jobs = body["jobs"] = nlohmann::json::array();
    for (const auto& job : service.store.sweep_jobs(sweep.id, false)) jobs.push_back(to_json(job, given));
  }
  if (body["active"] != 0) response.set_header("Retry-After", "1");
  if (!answer_not_modified(call, weak_etag(dump(body)), response)) answer_json(body, response);
}

void cancel(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const std::string id = find(service, call).id;
  const storage::CancelledJobs jobs = service.store.request_cancel_sweep(id);
  for (const std::string& job : jobs.running) service.queue.stop(job, StopReason::cancelled);
  for (const std::string& job : jobs.had_progress) service.queue.drop_progress(job);
  service.queue.wake();
  log::info("cancellation asked for", {{"request", call.request_id}, {"sweep", id}});
  const nlohmann::json body = to_json(find(service, call));
  answer_json(body, response, body["active"] == 0 ? 200 : 202);
}

SweepTable table_of(Service& service, const storage::Sweep& sweep) {
  const SweepBody given = body_of(sweep);
  std::vector<std::string> pointers;
  for (const Axis& axis : given.axes) pointers.push_back(axis.pointer);
  std::vector<SweepRow> rows;
  for (const auto& job : service.store.sweep_jobs(sweep.id, true)) {
    const auto index = static_cast<std::size_t>(job.index);
    rows.push_back({index, job.id, job.case_hash, values_at(given, choice_at(given.axes, given.mode, index)),
                    std::string(storage::to_string(job.state)),
                    job.summary ? nlohmann::json::parse(*job.summary) : nlohmann::json()});
  }
  return make_table(pointers, rows);
}

void get_table(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const SweepTable table = table_of(service, find(service, call));
  response.set_header("Vary", "Accept");
  if (call.request.get_header_value("Accept").find("text/csv") != std::string::npos) {
    response.set_content(to_csv(table), "text/csv; charset=utf-8");
  } else {
    answer_json(to_json(table), response);
  }
}

}  // namespace

void add_sweep(Router& router, Service& service) {
  router.add("GET", "/v1/sweeps/{id}",
             [&service](const Call& call, httplib::Response& response) { get(service, call, response); });
  router.add("POST", "/v1/sweeps/{id}:cancel",
             [&service](const Call& call, httplib::Response& response) { cancel(service, call, response); });
  router.add("GET", "/v1/sweeps/{id}/table", [&service](const Call& call, httplib::Response& response) {
    get_table(service, call, response);
  });
}

}  // namespace rouleau::service
