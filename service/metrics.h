#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "service/http/guarded_server.h"
#include "storage/job.h"

namespace prometheus {
class Registry;
template <typename T>
class Family;
class Counter;
class Gauge;
class Histogram;
}  // namespace prometheus

namespace rouleau::service {

/// What is not counted but read at the moment it is asked for.
struct MetricsNow {
  storage::QueueState queue;
  double oldest_waiting_s = 0;
  int workers = 0;
  double steps_per_second = 0;  ///< of all running jobs
  std::size_t connections = 0;
  int waiting_requests = 0;
  int streams = 0;
  std::uint64_t database_bytes = 0;
  std::uint64_t wal_bytes = 0;
  std::uint64_t archive_bytes = 0;
  std::uint64_t disk_free_bytes = 0;
};

/// What a Prometheus may watch. From any thread.
class Metrics {
 public:
  Metrics();
  ~Metrics();

  void note_answer(const Answered& answered);
  /// @param claimed  the job as it was when its attempt began
  /// @param after    what the attempt left it in
  void note_attempt(const storage::Job& claimed, storage::JobState after, storage::TimeMs now);

  /// All of them in Prometheus' text format.
  std::string text(const MetricsNow& now);

 private:
  void set(const MetricsNow& now);

  std::shared_ptr<prometheus::Registry> registry_;
  prometheus::Family<prometheus::Counter>& requests_;
  prometheus::Family<prometheus::Histogram>& request_seconds_;
  prometheus::Family<prometheus::Counter>& attempts_;
  prometheus::Histogram& wait_seconds_;
  prometheus::Histogram& run_seconds_;
  prometheus::Family<prometheus::Gauge>& jobs_;
  prometheus::Gauge& queue_depth_;
  prometheus::Gauge& queue_paused_;
  prometheus::Gauge& oldest_waiting_;
  prometheus::Gauge& workers_;
  prometheus::Gauge& steps_per_second_;
  prometheus::Gauge& connections_;
  prometheus::Gauge& waiting_requests_;
  prometheus::Gauge& streams_;
  prometheus::Gauge& database_bytes_;
  prometheus::Gauge& wal_bytes_;
  prometheus::Gauge& archive_bytes_;
  prometheus::Gauge& disk_free_bytes_;
  std::mutex mutex_;  ///< one reader at a time: what it sees is of one moment
};

}  // namespace rouleau::service
