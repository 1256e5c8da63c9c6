#include "service/queue/queue.h"

#include <chrono>
#include <exception>
#include <utility>

#include <nlohmann/json.hpp>

#include "service/http/problem.h"
#include "service/http/request_id.h"
#include "service/log.h"
#include "service/queue/job_files.h"
#include "service/queue/progress_json.h"

namespace rouleau::service {

namespace {

constexpr std::chrono::seconds heartbeat_interval{2};
// A job released with a gap becomes due without anybody waking a worker.
constexpr std::chrono::seconds idle_interval{1};
// An attempt that has given its job back has only to close its files.
constexpr std::chrono::seconds handover_time{1};

}  // namespace

Queue::Queue(storage::JobStore& store, const std::filesystem::path& data, KnownMachine& machine,
             std::chrono::duration<double> checkpoint_interval)
    : store_(store),
      archives_(data / "archives"),
      owner_("local-" + new_request_id()),
      logs_(data / "logs"),
      place_{store, live_, logs_, machine, archives_, checkpoint_interval} {
  std::filesystem::create_directories(archives_);
}

Queue::~Queue() {
  drain();
}

void Queue::start(int workers) {
  if (const int recovered = store_.recover(owner_); recovered > 0) {
    log::info("took back the jobs of a process that died", {{"jobs", std::to_string(recovered)}});
  }
  tidy_up();
  heartbeat_ = std::thread([this] { keep_leases(); });
  worker_count_ = workers;
  for (int i = 0; i < workers; ++i) workers_.emplace_back([this] { work(); });
}

void Queue::tidy_up() {
  using enum storage::JobState;
  tidy(archives_, [this](std::string_view id) {
    const auto job = store_.find(id);
    if (!job) return false;
    const bool may_be_retried = job->state == failed && !job->archive_size;
    return job->state == queued || job->state == paused || may_be_retried;
  });
}

void Queue::wake() {
  {
    const std::lock_guard lock(mutex_);
    ++wakes_;
  }
  woken_.notify_all();
  changes_.announce();
}

void Queue::stop(std::string_view id, StopReason reason) {
  if (const auto job = live_.find(id)) job->stop(reason);
  changes_.announce();
}

void Queue::drop_progress(std::string_view id) {
  remove_unfinished(archives_, id);
}

void Queue::forget(std::string_view id, const std::optional<std::string>& archive_id) {
  live_.forget(id);
  if (archive_id) remove_archive(archives_, *archive_id);
  remove_unfinished(archives_, id);
  logs_.remove(id);
  changes_.announce();
}

void Queue::drain() {
  {
    const std::lock_guard lock(mutex_);
    draining_ = true;
  }
  woken_.notify_all();
  for (const auto& job : live_.running()) job->stop(StopReason::draining);
  for (auto& worker : workers_) worker.join();
  workers_.clear();
  {
    const std::lock_guard lock(mutex_);
    leases_needed_ = false;
  }
  woken_.notify_all();
  if (heartbeat_.joinable()) heartbeat_.join();
  changes_.close();
}

void Queue::work() {
  std::unique_lock lock(mutex_);
  while (!draining_) {
    const auto seen = wakes_;
    lock.unlock();
    bool worked = false;
    try {
      worked = work_once();
    } catch (const std::exception& error) {
      log::error("no job could be claimed", {{"error", error.what()}});
    }
    lock.lock();
    if (!worked) woken_.wait_for(lock, idle_interval, [&] { return draining_ || wakes_ != seen; });
  }
}

bool Queue::work_once() {
  bool gave_results = false;
  auto claimed = store_.claim(owner_, lease_time, &gave_results);
  if (claimed || gave_results) changes_.announce();
  if (!claimed) return false;
  if (!live_.wait_until_ended(claimed->job.id, handover_time)) {
    // The last attempt lost its lease and has not stopped yet; both would write the same files.
    if (const auto last = live_.find(claimed->job.id)) last->stop(StopReason::lease_lost);
    store_.release(claimed->job.id, claimed->job.attempt, storage::system_clock_ms() + lease_time.count());
    return true;
  }
  const storage::Job begun = claimed->job;
  Attempt attempt(place_, std::move(*claimed));
  {
    // A drain that began between the claim and here has not seen this job.
    const std::lock_guard lock(mutex_);
    if (draining_) {
      for (const auto& job : live_.running()) job->stop(StopReason::draining);
    }
  }
  attempt.run();
  if (on_attempt_) on_attempt_(begun);
  changes_.announce();
  return true;
}

void Queue::renew_leases() {
  for (const auto& job : live_.running()) {
    const auto progress = job->progress();
    const auto lease =
        store_.renew(job->id(), job->attempt(), lease_time,
                     progress ? std::optional<std::string>(dump(to_json(*progress))) : std::nullopt);
    if (lease == storage::Lease::cancel_requested) job->stop(StopReason::cancelled);
    if (lease == storage::Lease::pause_requested) job->stop(StopReason::paused);
    // A job that has just ended is no longer held either; then nobody listens to this.
    if (lease == storage::Lease::lost) job->stop(StopReason::lease_lost);
  }
  if (store_.expire_leases() > 0) wake();
}

void Queue::keep_leases() {
  std::unique_lock lock(mutex_);
  while (leases_needed_) {
    lock.unlock();
    try {
      renew_leases();
    } catch (const std::exception& error) {
      log::error("leases could not be renewed", {{"error", error.what()}});
    }
    lock.lock();
    woken_.wait_for(lock, heartbeat_interval, [this] { return !leases_needed_; });
  }
}

}  // namespace rouleau::service
