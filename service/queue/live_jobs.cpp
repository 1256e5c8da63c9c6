#include "service/queue/live_jobs.h"

#include <algorithm>

namespace rouleau::service {

std::shared_ptr<LiveJob> LiveJobs::start(const std::string& id, int attempt) {
  auto job = std::make_shared<LiveJob>(id, attempt);
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const auto& old) { return old->id() == id; });
  running_[id] = job;
  return job;
}

void LiveJobs::end(const std::shared_ptr<LiveJob>& job, bool keep) {
  const std::lock_guard lock(mutex_);
  const auto found = running_.find(job->id());
  if (found == running_.end() || found->second != job) return;
  running_.erase(found);
  ended_.notify_all();
  if (!keep) return;
  kept_.push_back(job);
  if (kept_.size() > kept_after_end) kept_.pop_front();
}

void LiveJobs::forget(std::string_view id) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const auto& job) { return job->id() == id; });
}

bool LiveJobs::wait_until_ended(std::string_view id, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  return ended_.wait_for(lock, patience, [&] { return !running_.contains(id); });
}

std::shared_ptr<LiveJob> LiveJobs::find(std::string_view id) const {
  const std::lock_guard lock(mutex_);
  if (const auto found = running_.find(id); found != running_.end()) return found->second;
  const auto kept =
      std::find_if(kept_.begin(), kept_.end(), [&](const auto& job) { return job->id() == id; });
  return kept == kept_.end() ? nullptr : *kept;
}

std::vector<std::shared_ptr<LiveJob>> LiveJobs::running() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<LiveJob>> jobs;
  jobs.reserve(running_.size());
  for (const auto& [id, job] : running_) jobs.push_back(job);
  return jobs;
}

}  // namespace rouleau::service
