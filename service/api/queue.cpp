#include <algorithm>

#include <nlohmann/json.hpp>

#include "service/api/query.h"
#include "service/api/service.h"
#include "service/http/guarded_server.h"
#include "service/log.h"
#include "service/time_text.h"

namespace rouleau::service {

namespace {

void answer_queue(Service& service, httplib::Response& response) {
  const storage::QueueState queue = service.store.queue_state();
  nlohmann::json states = nlohmann::json::object();
  for (const auto& [state, count] : queue.counts) states[std::string(storage::to_string(state))] = count;
  nlohmann::json body{{"paused", queue.paused},
                      {"workers", service.queue.workers()},
                      {"depth", queue.counts.at(storage::JobState::queued)},
                      {"running", queue.counts.at(storage::JobState::running)},
                      {"states", std::move(states)},
                      {"oldest_waiting", nullptr},
                      {"oldest_age_s", nullptr}};
  if (queue.oldest_waiting) {
    body["oldest_waiting"] = format_time(*queue.oldest_waiting);
    const auto age = storage::system_clock_ms() - *queue.oldest_waiting;
    body["oldest_age_s"] = static_cast<double>(std::max<storage::TimeMs>(age, 0)) / 1000;
  }
  answer_json(body, response);
}

void pause(Service& service, const Call& call, httplib::Response& response, bool paused) {
  check_query(call, {});
  service.store.pause_queue(paused);
  if (!paused) service.queue.wake();
  log::info(paused ? "queue paused" : "queue resumed",
            {{"request", call.request_id}, {"caller", call.caller}});
  answer_queue(service, response);
}

}  // namespace

void add_queue(Router& router, Service& service) {
  router.add("GET", "/v1/queue", [&service](const Call& call, httplib::Response& response) {
    check_query(call, {});
    answer_queue(service, response);
  });
  router.add(
      "POST", "/v1/queue:pause",
      [&service](const Call& call, httplib::Response& response) { pause(service, call, response, true); },
      Body::none, Scope::admin);
  router.add(
      "POST", "/v1/queue:resume",
      [&service](const Call& call, httplib::Response& response) { pause(service, call, response, false); },
      Body::none, Scope::admin);
}

}  // namespace rouleau::service
