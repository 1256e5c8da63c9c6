#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "service/api/idempotency.h"
#include "service/api/queue_room.h"
#include "service/archive_use.h"
#include "service/http/router.h"
#include "service/known_machine.h"
#include "service/queue/queue.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// Event streams. Each holds a thread of the server's.
struct Streams {
  int most = 64;
  std::chrono::milliseconds comment_interval{15000};  ///< so that a client which has gone is noticed
  std::chrono::milliseconds longest{3600000};         ///< then the client connects again
  std::atomic<int> open = 0;
  std::atomic<int> epoch = 0;  ///< those begun in an earlier one end: whoever may still call connects again
};

/// What the resources of the API work on.
struct Service {
  storage::JobStore& store;
  Queue& queue;
  std::atomic<bool>& draining;
  KnownMachine& machine;
  QueueRoom room;
  std::size_t most_points = 10'000;  ///< of a sweep
  KeysInFlight keys{};
  std::atomic<int> waiting = 0;  ///< requests that wait for a change
  Streams streams{};
  ArchiveUse archive_use{};
};

// One file a resource; each adds its routes.
void add_jobs(Router& router, Service& service);         ///< /v1/jobs
void add_queue(Router& router, Service& service);        ///< /v1/queue
void add_job(Router& router, Service& service);          ///< /v1/jobs/{id}
void add_job_actions(Router& router, Service& service);  ///< what can be done to it
void add_events(Router& router, Service& service);       ///< /v1/jobs/{id}/events
void add_log(Router& router, Service& service);          ///< /v1/jobs/{id}/log
void add_sweeps(Router& router, Service& service);       ///< /v1/sweeps
void add_sweep(Router& router, Service& service);        ///< /v1/sweeps/{id}, its table, and its cancellation
void add_series(Router& router, Service& service);       ///< /v1/jobs/{id}/series
void add_frames(Router& router, Service& service);       ///< /v1/jobs/{id}/frames
void add_probes(Router& router, Service& service);       ///< /v1/jobs/{id}/probes
void add_archive(Router& router, Service& service);      ///< /v1/jobs/{id}/archive.h5
void add_cases(Router& router, Service& service);        ///< /v1/cases:validate, :plan, /v1/schema/case.json
void add_problems(Router& router);                       ///< /problems/{name}
void add_openapi(Router& router);                        ///< /openapi.json
void add_metrics(Router& router, std::function<std::string()> text);  ///< /metrics
void add_health(Router& router, const std::atomic<bool>& draining);   ///< /livez, /readyz

/// The job with the id of the route.
/// @throws Problem 404, 410
storage::Job find_job(Service& service, const Call& call);

/// The same, once its archive is there: it has succeeded, or gone unstable on its way.
/// @throws Problem 404, 409 not-finished
storage::Job find_finished(Service& service, const Call& call);

/// The archive of a job that has one.
std::filesystem::path archive_of(const Service& service, const storage::Job& job);

/// A job with its plan and its resolved case, as JSON.
std::string job_in_full(Service& service, const storage::Job& job);

}  // namespace rouleau::service
