#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "service/api/query.h"
#include "service/api/service.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/log.h"

namespace rouleau::service {

namespace {

using storage::Job;
using storage::JobState;

const char* what_is_possible(JobState state) {
  switch (state) {
    case JobState::queued:
    case JobState::running:
      return "it can be paused or cancelled";
    case JobState::paused:
      return "it can be resumed or cancelled";
    case JobState::cancelling:
      return "it will be cancelled in a moment, and can then be retried or deleted";
    case JobState::failed:
    case JobState::cancelled:
      return "it can be retried or deleted";
    case JobState::succeeded:
      return "it can be deleted";
  }
  return "";
}

Problem not_possible(const std::string& verb, JobState state) {
  return Problem(problems::invalid_transition, "the job is " + std::string(storage::to_string(state)) +
                                                   " and cannot be " + verb + "; " + what_is_possible(state));
}

[[noreturn]] void throw_no_job(Service& service, const std::string& id) {
  if (service.store.has_expired(id)) {
    throw Problem(problems::expired, "the job was removed to make room for others");
  }
  throw Problem(problems::not_found, "no job has this id");
}

/// A change of a job's state that the store puts on record and the queue may have to carry out.
struct Action {
  const char* verb;  ///< what is done to the job
  std::optional<Job> (storage::JobStore::*request)(std::string_view id);
  void (*carry_out)(Queue& queue, const Job& job);
  bool (*is_settled)(const Job& job);
};

void perform(Service& service, const Call& call, httplib::Response& response, const Action& action) {
  check_query(call, {});
  const std::string& id = call.part("id");
  try {
    const auto job = (service.store.*action.request)(id);
    if (!job) throw_no_job(service, id);
    action.carry_out(service.queue, *job);
    const std::string event = std::string("asked to be ") + action.verb;
    log::info(event, {{"request", call.request_id}, {"job", job->id}});
    service.queue.logs().note(*job, event, {{"request", call.request_id}});
    answer_json_text(job_in_full(service, *job), response, action.is_settled(*job) ? 200 : 202);
  } catch (const storage::InvalidTransition& error) {
    throw not_possible(action.verb, error.state());
  }
}

void cancel(Service& service, const Call& call, httplib::Response& response) {
  perform(service, call, response,
          {"cancelled", &storage::JobStore::request_cancel,
           [](Queue& queue, const Job& job) {
             queue.stop(job.id, StopReason::cancelled);
             // One that did not run has none to remove its files but us.
             if (job.state == JobState::cancelled) queue.drop_progress(job.id);
           },
           [](const Job& job) { return storage::has_ended(job.state); }});
}

void pause(Service& service, const Call& call, httplib::Response& response) {
  perform(service, call, response,
          {"paused", &storage::JobStore::request_pause,
           [](Queue& queue, const Job& job) { queue.stop(job.id, StopReason::paused); },
           [](const Job& job) { return job.state == JobState::paused; }});
}

void wake(Queue& queue, const Job&) {
  queue.wake();
}

bool is_settled_at_once(const Job&) {
  return true;
}

void resume(Service& service, const Call& call, httplib::Response& response) {
  perform(service, call, response, {"resumed", &storage::JobStore::resume, wake, is_settled_at_once});
}

void retry(Service& service, const Call& call, httplib::Response& response) {
  perform(service, call, response, {"retried", &storage::JobStore::retry, wake, is_settled_at_once});
}

void remove(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const std::string& id = call.part("id");
  try {
    const auto removed = service.store.remove(id);
    if (!removed) throw_no_job(service, id);
    service.queue.forget(id, removed->archive_id);
    log::info("job deleted", {{"request", call.request_id}, {"job", id}});
    response.status = 204;
  } catch (const storage::InvalidTransition& error) {
    throw not_possible("deleted", error.state());
  }
}

}  // namespace

Job find_job(Service& service, const Call& call) {
  auto job = service.store.find(call.part("id"));
  if (!job) throw_no_job(service, call.part("id"));
  return *job;
}

void add_job_actions(Router& router, Service& service) {
  const auto add = [&](const char* method, const char* path, auto* handler) {
    router.add(method, path, [&service, handler](const Call& call, httplib::Response& response) {
      handler(service, call, response);
    });
  };
  add("POST", "/v1/jobs/{id}:cancel", cancel);
  add("POST", "/v1/jobs/{id}:pause", pause);
  add("POST", "/v1/jobs/{id}:resume", resume);
  add("POST", "/v1/jobs/{id}:retry", retry);
  add("DELETE", "/v1/jobs/{id}", remove);
}

}  // namespace rouleau::service
