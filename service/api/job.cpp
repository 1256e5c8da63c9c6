#include <chrono>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/plan/plan.h"
#include "service/api/etag.h"
#include "service/api/job_json.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/api/waiting.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/queue/job_files.h"

namespace rouleau::service {

namespace {

/// The job once its state differs from what it was, or as it is when the time is up.
storage::Job wait_for_change(Service& service, const Call& call, std::chrono::milliseconds wait) {
  const auto deadline = SignalBoard::Clock::now() + wait;
  const Waiting waiting(service.waiting);
  if (waiting.too_many()) return find_job(service, call);
  std::uint64_t seen = service.queue.changes().version();
  storage::Job job = find_job(service, call);
  const storage::JobState before = job.state;
  while (job.state == before && !storage::has_ended(job.state) &&
         service.queue.changes().wait(seen, deadline)) {
    seen = service.queue.changes().version();
    job = find_job(service, call);
  }
  return job;
}

void get(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"wait"});
  const storage::Job job = wait_for_change(service, call, read_wait(call));
  std::string body = job_in_full(service, job);
  if (!storage::has_ended(job.state)) response.set_header("Retry-After", "1");
  if (!answer_not_modified(call, weak_etag(body), response)) answer_json_text(std::move(body), response);
}

}  // namespace

storage::Job find_finished(Service& service, const Call& call) {
  storage::Job job = find_job(service, call);
  if (!job.archive_size) {
    const std::string is = "the job is " + std::string(storage::to_string(job.state));
    throw Problem(problems::not_finished, storage::has_ended(job.state) ? is + " and left no archive" : is);
  }
  return job;
}

std::filesystem::path archive_of(const Service& service, const storage::Job& job) {
  service.archive_use.begin(job.archive_id.value());  // for the grace that begins now
  return archive_path(service.queue.archives(), job.archive_id.value());
}

std::string job_in_full(Service& service, const storage::Job& job) {
  std::string json = dump(to_json(job, service.queue.live()));
  json.pop_back();
  // Stored as JSON, and long: to read them only to write them again takes most of an answer's time.
  const auto text = service.store.case_text(job.id);
  if (text) json += ",\"case\":" + text->resolved;
  json += ",\"plan\":";
  // Those of a sweep are planned when somebody looks.
  const bool planned = job.plan != "null" || !text;
  json += planned ? job.plan : dump(to_json(make_plan(read_case(text->resolved), service.machine.get())));
  return json + '}';
}

void add_job(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}",
             [&service](const Call& call, httplib::Response& response) { get(service, call, response); });
}

}  // namespace rouleau::service
