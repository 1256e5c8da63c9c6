#include "service/metrics_reading.h"

#include <algorithm>
#include <system_error>

namespace rouleau::service {

namespace {

std::uint64_t size_of(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return error ? 0 : size;
}

std::uint64_t size_of_files_in(const std::filesystem::path& folder) {
  std::error_code error;
  std::uint64_t size = 0;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    size += size_of(entry->path());
  }
  return size;
}

}  // namespace

MetricsNow read_metrics(const Service& service, std::size_t connections, const std::filesystem::path& data) {
  MetricsNow now;
  now.queue = service.store.queue_state();
  if (now.queue.oldest_waiting) {
    const auto age = storage::system_clock_ms() - *now.queue.oldest_waiting;
    now.oldest_waiting_s = static_cast<double>(std::max<storage::TimeMs>(age, 0)) / 1000;
  }
  now.workers = service.queue.workers();
  for (const auto& job : service.queue.live().running()) {
    if (const auto progress = job->progress()) now.steps_per_second += progress->steps_per_second;
  }
  now.connections = connections;
  now.waiting_requests = service.waiting;
  now.streams = service.streams.open;
  now.database_bytes = size_of(data / "jobs.sqlite");
  now.wal_bytes = size_of(data / "jobs.sqlite-wal");
  now.archive_bytes = size_of_files_in(service.queue.archives());
  std::error_code error;
  const auto space = std::filesystem::space(data, error);
  if (!error) now.disk_free_bytes = space.available;
  return now;
}

}  // namespace rouleau::service
