#include "service/metrics.h"

#include <algorithm>
#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include "engine/simulation/run.h"

namespace rouleau::service {

namespace {

using prometheus::Registry;

const prometheus::Histogram::BucketBoundaries request_buckets{0.001, 0.005, 0.02, 0.1, 0.5, 2, 10, 60};
const prometheus::Histogram::BucketBoundaries job_buckets{0.1, 1, 10, 60, 600, 3600, 21600, 86400};

prometheus::Family<prometheus::Gauge>& gauges(Registry& registry, const std::string& name,
                                              const std::string& help) {
  return prometheus::BuildGauge().Name("rouleau_" + name).Help(help).Register(registry);
}

prometheus::Gauge& gauge(Registry& registry, const std::string& name, const std::string& help) {
  return gauges(registry, name, help).Add({});
}

prometheus::Family<prometheus::Counter>& counters(Registry& registry, const std::string& name,
                                                  const std::string& help) {
  return prometheus::BuildCounter().Name("rouleau_" + name).Help(help).Register(registry);
}

prometheus::Family<prometheus::Histogram>& histograms(Registry& registry, const std::string& name,
                                                      const std::string& help) {
  return prometheus::BuildHistogram().Name("rouleau_" + name).Help(help).Register(registry);
}

double seconds_between(storage::TimeMs from, storage::TimeMs to) {
  // The clock may have been set back.
  return static_cast<double>(std::max<storage::TimeMs>(to - from, 0)) / 1000;
}

}  // namespace

Metrics::Metrics()
    : registry_(std::make_shared<Registry>()),
      requests_(counters(*registry_, "http_requests_total", "Requests that were answered")),
      request_seconds_(histograms(*registry_, "http_request_seconds",
                                  "From the last byte of a request's head until its answer was made")),
      attempts_(counters(*registry_, "attempts_total", "Attempts at jobs, by what they left the job in")),
      wait_seconds_(histograms(*registry_, "job_wait_seconds", "From a job's submission until it was begun")
                        .Add({}, job_buckets)),
      run_seconds_(
          histograms(*registry_, "attempt_seconds", "How long attempts at jobs took").Add({}, job_buckets)),
      jobs_(gauges(*registry_, "jobs", "Jobs in each state")),
      queue_depth_(gauge(*registry_, "queue_depth", "Jobs that wait for a worker")),
      queue_paused_(gauge(*registry_, "queue_paused", "1 while no job is begun")),
      oldest_waiting_(gauge(*registry_, "queue_oldest_age_seconds", "Age of the oldest job that waits")),
      workers_(gauge(*registry_, "workers", "Jobs that run at a time, at most")),
      steps_per_second_(gauge(*registry_, "steps_per_second", "Time steps a second of all running jobs")),
      connections_(gauge(*registry_, "http_connections", "Open connections")),
      waiting_requests_(gauge(*registry_, "http_waiting_requests", "Requests that wait for a job to change")),
      streams_(gauge(*registry_, "http_streams", "Open event streams")),
      database_bytes_(gauge(*registry_, "database_bytes", "Size of the job store")),
      wal_bytes_(gauge(*registry_, "wal_bytes", "Size of the job store's write-ahead log")),
      archive_bytes_(gauge(*registry_, "archive_bytes", "Size of all archives and checkpoints")),
      disk_free_bytes_(gauge(*registry_, "disk_free_bytes", "What is left on the data folder's disk")) {
  gauges(*registry_, "build_info", "Always 1").Add({{"version", engine_version()}}).Set(1);
}

Metrics::~Metrics() = default;

void Metrics::note_answer(const Answered& answered) {
  requests_
      .Add({{"method", answered.method},
            {"route", answered.route},
            {"status", std::to_string(answered.status)}})
      .Increment();
  request_seconds_.Add({{"method", answered.method}, {"route", answered.route}}, request_buckets)
      .Observe(answered.seconds);
}

void Metrics::note_attempt(const storage::Job& claimed, storage::JobState after, storage::TimeMs now) {
  attempts_.Add({{"outcome", std::string(storage::to_string(after))}}).Increment();
  if (!claimed.started_at) return;
  if (claimed.attempt == 1) wait_seconds_.Observe(seconds_between(claimed.created_at, *claimed.started_at));
  run_seconds_.Observe(seconds_between(*claimed.started_at, now));
}

void Metrics::set(const MetricsNow& now) {
  for (const auto& [state, count] : now.queue.counts) {
    jobs_.Add({{"state", std::string(storage::to_string(state))}}).Set(static_cast<double>(count));
    if (state == storage::JobState::queued) queue_depth_.Set(static_cast<double>(count));
  }
  queue_paused_.Set(now.queue.paused ? 1 : 0);
  oldest_waiting_.Set(now.oldest_waiting_s);
  workers_.Set(now.workers);
  steps_per_second_.Set(now.steps_per_second);
  connections_.Set(static_cast<double>(now.connections));
  waiting_requests_.Set(now.waiting_requests);
  streams_.Set(now.streams);
  database_bytes_.Set(static_cast<double>(now.database_bytes));
  wal_bytes_.Set(static_cast<double>(now.wal_bytes));
  archive_bytes_.Set(static_cast<double>(now.archive_bytes));
  disk_free_bytes_.Set(static_cast<double>(now.disk_free_bytes));
}

std::string Metrics::text(const MetricsNow& now) {
  const std::lock_guard lock(mutex_);
  set(now);
  return prometheus::TextSerializer().Serialize(registry_->Collect());
}

}  // namespace rouleau::service
